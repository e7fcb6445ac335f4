#include "services/security/certificates.hpp"

#include <gtest/gtest.h>

#include "services/security/openssl.hpp"

namespace tandem::security {
namespace {

using std::chrono::days;

const Time kNow = from_stamp_ns(1'800'000'000'000'000'000);  // 2027-01-15 08:00:00 UTC
const Validity kAYear{kNow, kNow + days{365}};

TEST(Certificates, OfAHostIsSignedByItsAuthorityAndByNoOther) {
  const Identity authority = new_authority(kAYear);
  const Identity other = new_authority(kAYear);
  const Identity robot = new_host_identity(authority, "robot1", kAYear);

  const auto certificate = openssl::certificate_of(robot.certificate_pem);
  ASSERT_TRUE(certificate);
  const auto is_signed_by = [&](const Identity& one) {
    return X509_verify(certificate.get(), X509_get0_pubkey(openssl::certificate_of(one.certificate_pem).get())) == 1;
  };
  EXPECT_TRUE(is_signed_by(authority));
  EXPECT_FALSE(is_signed_by(other));
  EXPECT_EQ(X509_check_private_key(certificate.get(), openssl::key_of(robot.key_pem).get()), 1);
  EXPECT_EQ(X509_check_ca(certificate.get()), 0);
  EXPECT_EQ(X509_check_ca(openssl::certificate_of(authority.certificate_pem).get()), 1);
}

TEST(Certificates, HoldFromTheFirstToTheLastSecond) {
  const auto certificate = openssl::certificate_of(new_authority(kAYear).certificate_pem);

  EXPECT_EQ(openssl::begin_of(certificate.get()), kNow);
  EXPECT_EQ(openssl::end_of(certificate.get()), kNow + days{365});
}

TEST(Certificates, AHostsSubjectIsItsName) {
  EXPECT_EQ(subject_of(new_host_identity(new_authority(kAYear), "robot-2.lab", kAYear).certificate_pem),
            "CN=robot-2.lab");
}

TEST(Certificates, NoTwoAuthoritiesHaveOneName) {
  EXPECT_NE(subject_of(new_authority(kAYear).certificate_pem), subject_of(new_authority(kAYear).certificate_pem));
}

TEST(SignedDocument, CanBeReadAndGivesBackItsText) {
  const Identity authority = new_authority(kAYear);

  const std::string document = signed_document(authority, "<dds>\n  <grant/>\n</dds>\n");

  EXPECT_NE(document.find("multipart/signed"), std::string::npos);
  EXPECT_NE(document.find("<grant/>"), std::string::npos);
  std::string text = verified_document(document, authority.certificate_pem).value_or("");
  std::erase(text, '\r');  // S/MIME has the line ends of mail
  EXPECT_EQ(text, "<dds>\n  <grant/>\n</dds>\n");
}

TEST(SignedDocument, IsRefusedWhenChangedOrOfAnotherAuthority) {
  const Identity authority = new_authority(kAYear);
  std::string document = signed_document(authority, "role=laptop\n");

  EXPECT_FALSE(verified_document(document, new_authority(kAYear).certificate_pem));
  document.replace(document.find("laptop"), 6, "robot1");
  EXPECT_FALSE(verified_document(document, authority.certificate_pem));
  EXPECT_FALSE(verified_document("role=laptop\n", authority.certificate_pem));
  EXPECT_FALSE(verified_document("", authority.certificate_pem));
}

TEST(SignedDocument, OutlivesItsAuthoritysCertificateHere) {  // its time is judged apart, with a reason of its own
  const Identity expired = new_authority({from_stamp_ns(0), from_stamp_ns(1'000'000'000)});

  EXPECT_TRUE(verified_document(signed_document(expired, "text\n"), expired.certificate_pem));
}

}  // namespace
}  // namespace tandem::security
