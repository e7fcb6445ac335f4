#include "gateway/net/http_messages.hpp"

namespace tandem::net {
namespace {

constexpr const char* kContentPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; connect-src 'self'; "
    "manifest-src 'self'; worker-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

}  // namespace

std::string text_of(beast::string_view view) {
  return {view.data(), view.size()};
}

HttpRequest plain(const Request& request, const std::string& address) {
  return {.method = text_of(request.method_string()),
          .target = text_of(request.target()),
          .host = text_of(request[http::field::host]),
          .origin = text_of(request[http::field::origin]),
          .cookie = text_of(request[http::field::cookie]),
          .content_type = text_of(request[http::field::content_type]),
          .body = request.body(),
          .remote_address = address};
}

Response response_to(const Request& request, const HttpResponse& answer) {
  Response response{static_cast<http::status>(answer.status), request.version()};
  response.set(http::field::content_type, answer.content_type);
  response.set(http::field::cache_control, "no-store");
  response.set("Content-Security-Policy", kContentPolicy);
  response.set("X-Content-Type-Options", "nosniff");
  response.set("Referrer-Policy", "no-referrer");
  response.set("Permissions-Policy", "geolocation=(), camera=(), microphone=(), screen-wake-lock=(self)");
  response.set("Cross-Origin-Opener-Policy", "same-origin");
  if (!answer.set_cookie.empty()) response.set(http::field::set_cookie, answer.set_cookie);
  response.keep_alive(request.keep_alive() && answer.status < 400);
  response.body() = answer.body;
  response.prepare_payload();
  return response;
}

HttpResponse plain_error(int status, const std::string& text) {
  return {status, "text/plain", text + "\n", ""};
}

}  // namespace tandem::net
