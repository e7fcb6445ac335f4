#include "services/security/certificates.hpp"

#include <openssl/pem.h>
#include <openssl/rand.h>

#include <array>

#include "services/common/format.hpp"
#include "services/security/openssl.hpp"

namespace tandem::security {
namespace {

using namespace openssl;  // NOLINT: this file is made of it

constexpr const char* kAuthorityName = "Tandem link authority";

std::string random_word() {
  std::array<unsigned char, 4> bytes{};
  check(RAND_bytes(bytes.data(), bytes.size()) == 1, "draw random bytes");
  return formatted("%02x%02x%02x%02x", bytes[0], bytes[1], bytes[2], bytes[3]);
}

}  // namespace

Identity new_authority(const Validity& validity) {
  const Key key = new_key();
  // Fast DDS compares authorities by their names first: equal names would only be told apart by the signature.
  const std::string name = std::string{kAuthorityName} + " " + random_word();
  const openssl::Certificate certificate = new_certificate(key.get(), name, validity.begins, validity.ends);
  add_extension(certificate.get(), NID_basic_constraints, "critical,CA:TRUE");
  add_extension(certificate.get(), NID_key_usage, "critical,keyCertSign,digitalSignature");
  sign(certificate.get(), key.get());
  return {pem_of(certificate.get()), pem_of(key.get())};
}

Identity new_host_identity(const Identity& authority, const std::string& host, const Validity& validity) {
  const auto issuer = certificate_of(authority.certificate_pem);
  const Key issuer_key = key_of(authority.key_pem);
  check(issuer && issuer_key, "read the authority's certificate and key");
  const Key key = new_key();
  const auto certificate = new_certificate(key.get(), host, validity.begins, validity.ends);
  X509_set_issuer_name(certificate.get(), X509_get_subject_name(issuer.get()));
  add_extension(certificate.get(), NID_basic_constraints, "critical,CA:FALSE");
  add_extension(certificate.get(), NID_key_usage, "critical,digitalSignature,keyAgreement");
  sign(certificate.get(), issuer_key.get());
  return {pem_of(certificate.get()), pem_of(key.get())};
}

std::string subject_of(const std::string& certificate_pem) {
  const auto certificate = certificate_of(certificate_pem);
  check(certificate != nullptr, "read a certificate");
  const Bio text = writing();
  X509_NAME_print_ex(text.get(), X509_get_subject_name(certificate.get()), 0, XN_FLAG_RFC2253 & ~ASN1_STRFLGS_ESC_MSB);
  return contents_of(text);
}

std::string signed_document(const Identity& authority, const std::string& text) {
  const auto certificate = certificate_of(authority.certificate_pem);
  const Key key = key_of(authority.key_pem);
  check(certificate && key, "read the authority's certificate and key");
  constexpr int kReadable = PKCS7_TEXT | PKCS7_DETACHED;  // Fast DDS wants the text's own header
  const Bio content = reading(text);
  const Pkcs7 signature{PKCS7_sign(certificate.get(), key.get(), nullptr, content.get(), kReadable)};
  check(signature != nullptr, "sign a document");
  const Bio content_again = reading(text);
  const Bio document = writing();
  check(SMIME_write_PKCS7(document.get(), signature.get(), content_again.get(), kReadable) == 1, "write a signature");
  return contents_of(document);
}

std::optional<std::string> verified_document(const std::string& document, const std::string& authority_pem) {
  const auto authority = certificate_of(authority_pem);
  if (!authority) return std::nullopt;
  BIO* content = nullptr;
  const Pkcs7 signature{SMIME_read_PKCS7(reading(document).get(), &content)};
  const Bio owned{content};
  if (!signature) return std::nullopt;
  const Store store{X509_STORE_new()};
  X509_STORE_add_cert(store.get(), authority.get());
  X509_VERIFY_PARAM_set_flags(X509_STORE_get0_param(store.get()), X509_V_FLAG_NO_CHECK_TIME);
  const Bio text = writing();
  if (PKCS7_verify(signature.get(), nullptr, store.get(), content, text.get(), PKCS7_TEXT) != 1) return std::nullopt;
  return contents_of(text);
}

}  // namespace tandem::security
