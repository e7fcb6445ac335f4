#pragma once

#include <openssl/bio.h>
#include <openssl/evp.h>
#include <openssl/pkcs7.h>
#include <openssl/x509v3.h>

#include <memory>
#include <string>
#include <string_view>

#include "services/common/time.hpp"

/// OpenSSL's objects, owned, and the steps of which every certificate of ours is made. What OpenSSL cannot do throws
/// std::runtime_error.
namespace tandem::openssl {

template <auto kFree>
struct Freed {
  template <typename T>
  void operator()(T* pointer) const {
    kFree(pointer);
  }
};
using Key = std::unique_ptr<EVP_PKEY, Freed<EVP_PKEY_free>>;
using Certificate = std::unique_ptr<X509, Freed<X509_free>>;
using Bio = std::unique_ptr<BIO, Freed<BIO_free_all>>;
using Pkcs7 = std::unique_ptr<PKCS7, Freed<PKCS7_free>>;
using Store = std::unique_ptr<X509_STORE, Freed<X509_STORE_free>>;

/// Throws "OpenSSL cannot `what`" unless `ok`.
void check(bool ok, const char* what);

/// A stream that reads `text`, which must outlive it; and one that is written to.
[[nodiscard]] Bio reading(std::string_view text);
[[nodiscard]] Bio writing();
[[nodiscard]] std::string contents_of(const Bio& written);

/// A new P-256 key.
[[nodiscard]] Key new_key();
/// A certificate of `key`, named CN=`name`, with a random serial number, valid in [begins, ends]; its issuer is itself,
/// and it is not signed yet.
[[nodiscard]] Certificate new_certificate(EVP_PKEY* key, const std::string& name, Time begins, Time ends);
void add_extension(X509* certificate, int nid, const std::string& value);
/// To be done last.
void sign(X509* certificate, EVP_PKEY* key);

[[nodiscard]] std::string pem_of(X509* certificate);
[[nodiscard]] std::string pem_of(EVP_PKEY* key);
/// Nothing if the text holds none.
[[nodiscard]] Certificate certificate_of(std::string_view pem);
[[nodiscard]] Key key_of(std::string_view pem);

[[nodiscard]] Time begin_of(X509* certificate);
[[nodiscard]] Time end_of(X509* certificate);

}  // namespace tandem::openssl
