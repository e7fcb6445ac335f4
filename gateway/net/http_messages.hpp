#pragma once
// Private to the translation unit that knows Boost, as boost_net.hpp is.

#include <string>

#include "gateway/net/boost_net.hpp"
#include "gateway/net/https_server.hpp"

namespace tandem::net {

using Request = http::request<http::string_body>;
using Response = http::response<http::string_body>;

[[nodiscard]] std::string text_of(beast::string_view view);

/// `request` without Boost, for those who decide about it; it came from `address`.
[[nodiscard]] HttpRequest plain(const Request& request, const std::string& address);

/// `answer` to `request`, with the headers that every answer of ours carries.
[[nodiscard]] Response response_to(const Request& request, const HttpResponse& answer);

[[nodiscard]] HttpResponse plain_error(int status, const std::string& text);

}  // namespace tandem::net
