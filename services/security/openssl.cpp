#include "services/security/openssl.hpp"

#include <openssl/ec.h>
#include <openssl/pem.h>
#include <openssl/rand.h>

#include <array>
#include <ctime>
#include <stdexcept>

namespace tandem::openssl {
namespace {

std::time_t unix_s(Time time) {
  return static_cast<std::time_t>(to_stamp_ns(time) / 1'000'000'000);
}

Time time_of(const ASN1_TIME* time) {
  std::tm utc{};
  check(ASN1_TIME_to_tm(time, &utc) == 1, "read the time in a certificate");
  return from_stamp_ns(static_cast<std::int64_t>(timegm(&utc)) * 1'000'000'000);
}

}  // namespace

void check(bool ok, const char* what) {
  if (!ok) throw std::runtime_error(std::string{"OpenSSL cannot "} + what);
}

Bio reading(std::string_view text) {
  Bio bio{BIO_new_mem_buf(text.data(), static_cast<int>(text.size()))};
  check(bio != nullptr, "read from memory");
  return bio;
}

Bio writing() {
  Bio bio{BIO_new(BIO_s_mem())};
  check(bio != nullptr, "write to memory");
  return bio;
}

std::string contents_of(const Bio& written) {
  char* data = nullptr;
  const long size = BIO_get_mem_data(written.get(), &data);
  return {data, static_cast<std::size_t>(size)};
}

Key new_key() {
  Key key{EVP_EC_gen("P-256")};
  check(key != nullptr, "make a key");
  return key;
}

Certificate new_certificate(EVP_PKEY* key, const std::string& name, Time begins, Time ends) {
  Certificate certificate{X509_new()};
  check(certificate != nullptr, "make a certificate");
  X509_set_version(certificate.get(), X509_VERSION_3);
  std::array<unsigned char, 16> serial{};
  check(RAND_bytes(serial.data(), serial.size()) == 1, "draw a serial number");
  serial[0] &= 0x7f;
  const std::unique_ptr<BIGNUM, Freed<BN_free>> number{BN_bin2bn(serial.data(), serial.size(), nullptr)};
  BN_to_ASN1_INTEGER(number.get(), X509_get_serialNumber(certificate.get()));
  check(ASN1_TIME_set(X509_getm_notBefore(certificate.get()), unix_s(begins)) != nullptr &&
            ASN1_TIME_set(X509_getm_notAfter(certificate.get()), unix_s(ends)) != nullptr,
        "write the time into a certificate");
  X509_set_pubkey(certificate.get(), key);
  X509_NAME* subject = X509_get_subject_name(certificate.get());
  check(X509_NAME_add_entry_by_txt(subject, "CN", MBSTRING_UTF8, reinterpret_cast<const unsigned char*>(name.data()),
                                   static_cast<int>(name.size()), -1, 0) == 1,
        "write a name into a certificate");
  X509_set_issuer_name(certificate.get(), subject);
  return certificate;
}

void add_extension(X509* certificate, int nid, const std::string& value) {
  X509V3_CTX context;
  X509V3_set_ctx_nodb(&context);
  X509V3_set_ctx(&context, certificate, certificate, nullptr, nullptr, 0);
  const std::unique_ptr<X509_EXTENSION, Freed<X509_EXTENSION_free>> extension{
      X509V3_EXT_conf_nid(nullptr, &context, nid, value.c_str())};
  check(extension && X509_add_ext(certificate, extension.get(), -1) == 1, "add a certificate extension");
}

void sign(X509* certificate, EVP_PKEY* key) {
  check(X509_sign(certificate, key, EVP_sha256()) > 0, "sign a certificate");
}

std::string pem_of(X509* certificate) {
  const Bio text = writing();
  check(PEM_write_bio_X509(text.get(), certificate) == 1, "write a certificate");
  return contents_of(text);
}

std::string pem_of(EVP_PKEY* key) {
  const Bio text = writing();
  check(PEM_write_bio_PrivateKey(text.get(), key, nullptr, nullptr, 0, nullptr, nullptr) == 1, "write a key");
  return contents_of(text);
}

Certificate certificate_of(std::string_view pem) {
  return Certificate{PEM_read_bio_X509(reading(pem).get(), nullptr, nullptr, nullptr)};
}

Key key_of(std::string_view pem) {
  return Key{PEM_read_bio_PrivateKey(reading(pem).get(), nullptr, nullptr, nullptr)};
}

Time begin_of(X509* certificate) {
  return time_of(X509_get0_notBefore(certificate));
}

Time end_of(X509* certificate) {
  return time_of(X509_get0_notAfter(certificate));
}

}  // namespace tandem::openssl
