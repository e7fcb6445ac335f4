#include "gateway/net/certificate.hpp"

#include <arpa/inet.h>
#include <openssl/rand.h>

#include <array>
#include <memory>
#include <stdexcept>

#include "services/common/clock.hpp"
#include "services/common/file_io.hpp"
#include "services/security/openssl.hpp"

namespace tandem::net {
namespace {

using openssl::check;

constexpr std::chrono::days kValid{397};
constexpr std::chrono::days kValidBefore{1};  // phones' clocks are not exact

std::string hex_of(const unsigned char* bytes, std::size_t count) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    text += kDigits[bytes[i] >> 4];
    text += kDigits[bytes[i] & 15];
  }
  return text;
}

bool is_address(const std::string& name) {
  std::array<unsigned char, 16> bytes{};
  return inet_pton(AF_INET, name.c_str(), bytes.data()) == 1 || inet_pton(AF_INET6, name.c_str(), bytes.data()) == 1;
}

std::string fingerprint_of(X509* certificate) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int size = 0;
  check(X509_digest(certificate, EVP_sha256(), digest.data(), &size) == 1, "hash a certificate");
  return hex_of(digest.data(), 8);
}

Certificate new_certificate(const std::vector<std::string>& names) {
  const openssl::Key key = openssl::new_key();
  const Time now = wall_time();
  const openssl::Certificate certificate =
      openssl::new_certificate(key.get(), "Tandem gateway", now - kValidBefore, now + kValid);
  std::string alternatives;
  for (const auto& name : names) {
    alternatives += (alternatives.empty() ? "" : ",") + std::string{is_address(name) ? "IP:" : "DNS:"} + name;
  }
  openssl::add_extension(certificate.get(), NID_subject_alt_name, alternatives);
  openssl::add_extension(certificate.get(), NID_basic_constraints, "critical,CA:FALSE");
  openssl::add_extension(certificate.get(), NID_key_usage, "critical,digitalSignature");
  openssl::add_extension(certificate.get(), NID_ext_key_usage, "serverAuth");
  openssl::sign(certificate.get(), key.get());
  return {openssl::pem_of(certificate.get()), openssl::pem_of(key.get()), fingerprint_of(certificate.get())};
}

bool names_all(X509* certificate, const std::vector<std::string>& names) {
  for (const auto& name : names) {
    const int found = is_address(name) ? X509_check_ip_asc(certificate, name.c_str(), 0)
                                       : X509_check_host(certificate, name.c_str(), name.size(), 0, nullptr);
    if (found != 1) return false;
  }
  return true;
}

/// The kept certificate, if it is still good for `names`.
std::unique_ptr<Certificate> kept_certificate(const std::filesystem::path& certificate_file,
                                              const std::filesystem::path& key_file,
                                              const std::vector<std::string>& names) {
  if (!std::filesystem::exists(certificate_file) || !std::filesystem::exists(key_file)) return nullptr;
  Certificate kept{read_file(certificate_file), read_file(key_file), ""};
  const openssl::Certificate certificate = openssl::certificate_of(kept.certificate_pem);
  if (!certificate || openssl::end_of(certificate.get()) < wall_time()) return nullptr;
  if (!names_all(certificate.get(), names)) return nullptr;
  kept.fingerprint = fingerprint_of(certificate.get());
  return std::make_unique<Certificate>(std::move(kept));
}

}  // namespace

Certificate load_or_create_certificate(const std::filesystem::path& folder, const std::vector<std::string>& names) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw std::runtime_error("cannot make the folder " + folder.string() + ": " + error.message());
  const auto certificate_file = folder / "gateway.crt";
  const auto key_file = folder / "gateway.key";
  if (const auto kept = kept_certificate(certificate_file, key_file, names)) return *kept;

  const Certificate made = new_certificate(names);
  write_private_file(key_file, made.private_key_pem);
  write_file_atomically(certificate_file, made.certificate_pem);
  return made;
}

std::string random_hex(std::size_t count) {
  std::string bytes(count, '\0');
  check(RAND_bytes(reinterpret_cast<unsigned char*>(bytes.data()), static_cast<int>(count)) == 1, "draw random bytes");
  return hex_of(reinterpret_cast<const unsigned char*>(bytes.data()), count);
}

std::string sha256_hex(const std::string& text) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int size = 0;
  check(EVP_Digest(text.data(), text.size(), digest.data(), &size, EVP_sha256(), nullptr) == 1, "hash");
  return hex_of(digest.data(), size);
}

}  // namespace tandem::net
