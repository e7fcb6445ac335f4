#include "gateway/net/https_server.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <stdexcept>

#include "gateway/net/websocket_client.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tandem::net {
namespace {

using namespace std::chrono_literals;

/// Waits for news of a server or a phone: true as soon as `condition` holds, false after 10 s.
template <typename Source>
bool eventually(Source& source, const std::function<bool()>& condition) {
  for (const auto end = std::chrono::steady_clock::now() + 10s; !condition();) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
    if (left <= 0ms) return false;
    source.wait(left);
  }
  return true;
}

/// Lets in whoever brings the token "good", once.
class OneToken final : public Gatekeeper {
 public:
  std::optional<HttpResponse> refusal(const HttpRequest& request) override {
    if (request.host.rfind("127.0.0.1:", 0) == 0) return std::nullopt;
    return HttpResponse{403, "text/plain", "", ""};
  }
  HttpResponse post(const HttpRequest& request) override {
    if (request.target != "/api/pair" || request.body != R"({"token":"good"})" || used_)
      return {403, "text/plain", "", ""};
    used_ = true;
    return {200, "application/json", "{}", "__Host-sid=s3cret; Path=/; Secure; HttpOnly; SameSite=Strict"};
  }
  Admission admit(const HttpRequest& request) override {
    if (request.cookie == "__Host-sid=s3cret") return {101, "alice"};
    return {401, ""};
  }

 private:
  bool used_ = false;
};

class HttpsServerTest : public testing::Test {
 protected:
  HttpsServerTest() : certificate_(load_or_create_certificate(folder_.path(), {"localhost", "127.0.0.1"})) {}

  static HttpsServer::Options options() {
    HttpsServer::Options options;
    options.address = "127.0.0.1";
    return options;
  }
  [[nodiscard]] PairingLink link(const HttpsServer& server, const std::string& token) const {
    return {"127.0.0.1", server.port(), token, certificate_.fingerprint};
  }
  /// Collects what happens until an event of `kind` is there.
  static SocketEvent next(HttpsServer& server, SocketEvent::Kind kind) {
    SocketEvent found;
    EXPECT_TRUE(eventually(server, [&] {
      for (auto& event : server.take()) {
        if (event.kind == kind) {
          found = std::move(event);
          return true;
        }
      }
      return false;
    }));
    return found;
  }

  test::TemporaryFolder folder_;
  Certificate certificate_;
  std::vector<Asset> assets_;
  OneToken gatekeeper_;
};

TEST_F(HttpsServerTest, PairsAPhoneAndTalksBothWays) {
  HttpsServer server{options(), certificate_, assets_, gatekeeper_};
  WebSocketClient phone{link(server, "good")};
  const SocketEvent opened = next(server, SocketEvent::Kind::Opened);
  EXPECT_EQ(opened.session, "alice");
  ASSERT_TRUE(eventually(phone, [&] { return phone.state() == WebSocketClient::State::Connected; })) << phone.reason();

  ASSERT_TRUE(phone.send("hello"));
  EXPECT_EQ(next(server, SocketEvent::Kind::Text).text, "hello");

  server.send(opened.socket, "first");
  server.send(opened.socket, "second");
  std::vector<std::string> texts;
  ASSERT_TRUE(eventually(phone, [&] {
    for (auto& text : phone.take()) texts.push_back(text);
    return texts.size() == 2;
  }));
  EXPECT_EQ(texts, (std::vector<std::string>{"first", "second"}));

  server.send_latest(opened.socket, "belief", std::string{"\x01\x00\x02", 3}, true);
  std::vector<std::string> binaries;
  ASSERT_TRUE(eventually(phone, [&] {
    for (auto& one : phone.take_binary()) binaries.push_back(one);
    return !binaries.empty();
  }));
  EXPECT_EQ(binaries.front(), (std::string{"\x01\x00\x02", 3}));
}

TEST_F(HttpsServerTest, ComesBackWithItsCookieAfterALostConnection) {
  HttpsServer server{options(), certificate_, assets_, gatekeeper_};
  WebSocketClient phone{link(server, "good"), {.retry = 10ms}};
  const SocketEvent opened = next(server, SocketEvent::Kind::Opened);
  server.close(opened.socket, 1012, "again");
  next(server, SocketEvent::Kind::Opened);
  EXPECT_TRUE(eventually(phone, [&] { return phone.connections() == 2; }));
}

TEST_F(HttpsServerTest, RefusesAWrongToken) {
  HttpsServer server{options(), certificate_, assets_, gatekeeper_};
  WebSocketClient phone{link(server, "guess")};
  EXPECT_TRUE(eventually(phone, [&] { return phone.state() == WebSocketClient::State::Refused; }));
  EXPECT_TRUE(server.take().empty());
}

TEST_F(HttpsServerTest, ClientRefusesAnotherCertificate) {
  HttpsServer server{options(), certificate_, assets_, gatekeeper_};
  PairingLink wrong = link(server, "good");
  wrong.fingerprint = "0000000000000000";
  WebSocketClient phone{wrong};
  EXPECT_TRUE(eventually(phone, [&] { return phone.state() == WebSocketClient::State::Refused; }));
  EXPECT_EQ(phone.reason(), "the certificate is not the one in the link");
}

TEST_F(HttpsServerTest, ClosesAPhoneThatSendsMoreThanAMessageMayHave) {
  HttpsServer server{options(), certificate_, assets_, gatekeeper_};
  WebSocketClient phone{link(server, "good"), {.retry = 10s}};
  next(server, SocketEvent::Kind::Opened);
  ASSERT_TRUE(eventually(phone, [&] { return phone.send(std::string(17 * 1024, 'x')); }));
  next(server, SocketEvent::Kind::Closed);
  EXPECT_TRUE(eventually(phone, [&] { return phone.reason().rfind("closed: 1009", 0) == 0; })) << phone.reason();
}

TEST_F(HttpsServerTest, TakenPortIsAClearError) {
  HttpsServer first{options(), certificate_, assets_, gatekeeper_};
  auto taken = options();
  taken.port = first.port();
  try {
    HttpsServer second{taken, certificate_, assets_, gatekeeper_};
    FAIL() << "two servers on one port";
  } catch (const std::runtime_error& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("cannot listen on 127.0.0.1 port " + std::to_string(first.port())), std::string::npos) << what;
    EXPECT_NE(what.find("choose another port"), std::string::npos) << what;
  }
}

TEST_F(HttpsServerTest, CertificateIsKeptUntilItMustNameMore) {
  EXPECT_EQ(load_or_create_certificate(folder_.path(), {"localhost"}).fingerprint, certificate_.fingerprint);
  EXPECT_NE(load_or_create_certificate(folder_.path(), {"localhost", "192.168.4.1"}).fingerprint,
            certificate_.fingerprint);
  const auto rights = std::filesystem::status(folder_ / "gateway.key").permissions();
  EXPECT_EQ(rights, std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
}

}  // namespace
}  // namespace tandem::net
