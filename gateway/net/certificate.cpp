#include "gateway/net/certificate.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <openssl/bio.h>
#include <openssl/ec.h>
#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/rand.h>
#include <openssl/x509v3.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <memory>
#include <stdexcept>

#include "services/common/file_io.hpp"

namespace tandem::net {
namespace {

template <auto kFree>
struct Freed {
  template <typename T>
  void operator()(T* pointer) const {
    kFree(pointer);
  }
};
using Key = std::unique_ptr<EVP_PKEY, Freed<EVP_PKEY_free>>;
using X509Ptr = std::unique_ptr<X509, Freed<X509_free>>;
using Bio = std::unique_ptr<BIO, Freed<BIO_free_all>>;

constexpr int kValidDays = 397;

void check(bool ok, const char* what) {
  if (!ok) throw std::runtime_error(std::string{"OpenSSL cannot "} + what);
}

std::string hex_of(const unsigned char* bytes, std::size_t count) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    text += kDigits[bytes[i] >> 4];
    text += kDigits[bytes[i] & 15];
  }
  return text;
}

std::string contents_of(const Bio& bio) {
  char* data = nullptr;
  const long size = BIO_get_mem_data(bio.get(), &data);
  return {data, static_cast<std::size_t>(size)};
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

void add_extension(X509* certificate, int nid, const std::string& value) {
  X509V3_CTX context;
  X509V3_set_ctx_nodb(&context);
  X509V3_set_ctx(&context, certificate, certificate, nullptr, nullptr, 0);
  const std::unique_ptr<X509_EXTENSION, Freed<X509_EXTENSION_free>> extension{
      X509V3_EXT_conf_nid(nullptr, &context, nid, value.c_str())};
  check(extension && X509_add_ext(certificate, extension.get(), -1) == 1, "add a certificate extension");
}

Certificate new_certificate(const std::vector<std::string>& names) {
  const Key key{EVP_EC_gen("P-256")};
  const X509Ptr certificate{X509_new()};
  check(key && certificate, "make a key");
  X509_set_version(certificate.get(), X509_VERSION_3);
  std::array<unsigned char, 16> serial{};
  check(RAND_bytes(serial.data(), serial.size()) == 1, "draw a serial number");
  serial[0] &= 0x7f;
  const std::unique_ptr<BIGNUM, Freed<BN_free>> number{BN_bin2bn(serial.data(), serial.size(), nullptr)};
  BN_to_ASN1_INTEGER(number.get(), X509_get_serialNumber(certificate.get()));
  X509_gmtime_adj(X509_getm_notBefore(certificate.get()), -24L * 3600);  // phones' clocks are not exact
  X509_gmtime_adj(X509_getm_notAfter(certificate.get()), kValidDays * 24L * 3600);
  X509_set_pubkey(certificate.get(), key.get());
  X509_NAME* subject = X509_get_subject_name(certificate.get());
  X509_NAME_add_entry_by_txt(subject, "CN", MBSTRING_UTF8, reinterpret_cast<const unsigned char*>("Tandem gateway"), -1,
                             -1, 0);
  X509_set_issuer_name(certificate.get(), subject);
  std::string alternatives;
  for (const auto& name : names) {
    alternatives += (alternatives.empty() ? "" : ",") + std::string{is_address(name) ? "IP:" : "DNS:"} + name;
  }
  add_extension(certificate.get(), NID_subject_alt_name, alternatives);
  add_extension(certificate.get(), NID_basic_constraints, "critical,CA:FALSE");
  add_extension(certificate.get(), NID_key_usage, "critical,digitalSignature");
  add_extension(certificate.get(), NID_ext_key_usage, "serverAuth");
  check(X509_sign(certificate.get(), key.get(), EVP_sha256()) > 0, "sign a certificate");

  const Bio certificate_text{BIO_new(BIO_s_mem())};
  const Bio key_text{BIO_new(BIO_s_mem())};
  check(PEM_write_bio_X509(certificate_text.get(), certificate.get()) == 1, "write a certificate");
  check(PEM_write_bio_PrivateKey(key_text.get(), key.get(), nullptr, nullptr, 0, nullptr, nullptr) == 1, "write a key");
  return {contents_of(certificate_text), contents_of(key_text), fingerprint_of(certificate.get())};
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
  const Bio text{BIO_new_mem_buf(kept.certificate_pem.data(), static_cast<int>(kept.certificate_pem.size()))};
  const X509Ptr certificate{PEM_read_bio_X509(text.get(), nullptr, nullptr, nullptr)};
  if (!certificate || X509_cmp_current_time(X509_get0_notAfter(certificate.get())) < 0) return nullptr;
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
  const mode_t before = umask(0077);
  write_file_atomically(key_file, made.private_key_pem);
  umask(before);
  chmod(key_file.c_str(), 0600);
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
