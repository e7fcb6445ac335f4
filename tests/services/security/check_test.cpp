#include "services/security/check.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "services/common/file_io.hpp"
#include "services/security/certificates.hpp"
#include "services/security/documents.hpp"
#include "services/security/host_files.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tandem::security {
namespace {

namespace fs = std::filesystem;
using std::chrono::days;

const Time kNow = from_stamp_ns(1'800'000'000'000'000'000);  // 2027-01-15 08:00:00 UTC
const Validity kAYear{kNow, kNow + days{365}};

/// A lab with one robot, whose files are good.
class Check : public testing::Test {
 protected:
  Check() {
    make_authority(lab_.path(), kAYear);
    folder_ = make_host_files(lab_.path(), "robot1", {"", "robot1", {"robot_pose"}, {"team_plan"}, kAYear});
    files_ = security_files_in(folder_);
  }
  [[nodiscard]] std::vector<std::string> problems(Time now = kNow) const { return problems_of(files_, expected_, now); }
  /// The only problem, without the folder in front.
  [[nodiscard]] std::string problem(Time now = kNow) const {
    const auto all = problems(now);
    if (all.size() != 1) return "problems: " + std::to_string(all.size());
    return all[0].starts_with(folder_.string() + "/") ? all[0].substr(folder_.string().size() + 1) : all[0];
  }
  /// The files of another host of the lab, or of another lab.
  static SecurityFiles made_in(const fs::path& lab, const std::string& host, const Validity& validity = kAYear) {
    return security_files_in(make_host_files(lab, host, {"", "robot1", {"robot_pose"}, {"team_plan"}, validity}));
  }
  static void replace(const fs::path& file, const fs::path& by) {
    fs::copy_file(by, file, fs::copy_options::overwrite_existing);
  }

  test::TemporaryFolder lab_;
  fs::path folder_;
  SecurityFiles files_;
  Expected expected_{"robot1", "robot1", 20, {"robot_pose"}, {"team_plan"}};
};

TEST_F(Check, FindsNothingWrongWithWhatWasMade) {
  EXPECT_EQ(problems(), std::vector<std::string>{});
  EXPECT_EQ(end_of(files_), kNow + days{365});
}

TEST_F(Check, EveryMissingFileIsNamed) {
  for (const auto& file : {files_.authority, files_.certificate, files_.key, files_.governance, files_.permissions}) {
    const std::string content = read_file(file);
    fs::remove(file);
    EXPECT_EQ(problem(),
              file.filename().string() +
                  ": cannot be read: No such file or directory. Copy here what tandem secure add robot1 made");
    write_private_file(file, content);
  }
  EXPECT_TRUE(problems().empty());
}

TEST_F(Check, AKeyThatOthersMayReadIsRefused) {
  fs::permissions(files_.key, fs::perms{0640});

  EXPECT_EQ(problem(), "host.key: others may read it (mode 640); if they could, make a new one. Then: chmod 600 " +
                           files_.key.string());
}

TEST_F(Check, ACertificateThatExpiredIsNamedWithBothTimesAndAskedOfTheClock) {
  files_ = made_in(lab_.path(), "robot1", {kNow, kNow + days{1}});

  EXPECT_TRUE(problems(kNow + days{1}).empty());
  const auto all = problems(kNow + days{2});
  ASSERT_EQ(all.size(), 1U);  // permissions are not asked before the certificate is right
  EXPECT_EQ(all[0],
            files_.certificate.string() +
                ": expired at 2027-01-16T08:00:00 UTC, and it is 2027-01-17T08:00:00 UTC now. Is this machine's "
                "clock right? If so, make this host's files again: tandem secure add robot1");
}

TEST_F(Check, AClockBeforeTheCertificateIsNamed) {
  const auto all = problems(kNow - days{300});
  ASSERT_EQ(all.size(), 2U);  // the authority's and the host's
  EXPECT_NE(all[1].find("host.crt: not valid before 2027-01-15T08:00:00 UTC, and it is 2026-03-21T08:00:00 UTC now. Is "
                        "this machine's clock right?"),
            std::string::npos)
      << all[1];
}

TEST_F(Check, PermissionsThatExpiredBeforeTheCertificateAreNamed) {
  const Identity authority{read_file(lab_ / "authority.crt"), read_file(lab_ / "authority.key")};
  const Permissions short_lived{"CN=robot1", "robot1", {"robot_pose"}, {"team_plan"}, {kNow, kNow + days{1}}};
  write_file_atomically(files_.permissions, signed_document(authority, permissions_xml(short_lived)));

  EXPECT_TRUE(problems(kNow + days{1}).empty());
  const std::string late = problem(kNow + days{2});
  EXPECT_TRUE(late.starts_with("permissions.p7s: expired at 2027-01-16T08:00:00 UTC")) << late;
  EXPECT_EQ(end_of(files_), kNow + days{1});
}

TEST_F(Check, AKeyOfAnotherCertificateIsNamed) {
  replace(files_.key, made_in(lab_.path(), "robot2").key);

  EXPECT_EQ(problem(), "host.key: not the key of host.crt; make this host's files again: tandem secure add robot1");
}

TEST_F(Check, ACertificateOfAnotherAuthorityIsNamed) {
  const test::TemporaryFolder elsewhere;
  make_authority(elsewhere.path(), kAYear);
  const SecurityFiles foreign = made_in(elsewhere.path(), "robot1");
  replace(files_.certificate, foreign.certificate);
  replace(files_.key, foreign.key);

  EXPECT_EQ(problem(),
            "host.crt: not signed by the authority in authority.crt: files of two authorities are mixed. "
            "Take all of them from one authority's folder");
}

TEST_F(Check, DocumentsOfAnotherAuthorityAreNamed) {
  const test::TemporaryFolder elsewhere;
  make_authority(elsewhere.path(), kAYear);
  const SecurityFiles foreign = made_in(elsewhere.path(), "robot1");

  replace(files_.permissions, foreign.permissions);
  EXPECT_EQ(problem(),
            "permissions.p7s: not signed by the authority in authority.crt, or changed afterwards; make this "
            "host's files again: tandem secure add robot1");
  replace(files_.governance, foreign.governance);
  EXPECT_EQ(problems().size(), 2U);
}

TEST_F(Check, AGovernanceThatLeavesSomethingInTheClearIsNamed) {
  std::string xml = governance_xml();
  const std::string encrypted = "<metadata_protection_kind>ENCRYPT";
  xml.replace(xml.find(encrypted), encrypted.size(), "<metadata_protection_kind>NONE");
  const Identity authority{read_file(lab_.path() / "authority.crt"), read_file(lab_.path() / "authority.key")};
  write_file_atomically(files_.governance, signed_document(authority, xml));

  EXPECT_EQ(problem(),
            "governance.p7s: metadata_protection_kind is \"NONE\", and hosts take only what is encrypted; make a new "
            "authority: tandem secure init");
}

TEST_F(Check, PermissionsOfAnotherSubjectAreNamed) {
  replace(files_.permissions, made_in(lab_.path(), "laptop1").permissions);

  EXPECT_EQ(problem(),
            "permissions.p7s: they are for the subject \"CN=laptop1\", and this host's certificate has "
            "\"CN=robot1\"; make this host's files again: tandem secure add robot1");
}

TEST_F(Check, AnotherHostsFilesAreNamed) {
  expected_.host = "robot7";

  EXPECT_EQ(problem(), "host.crt: it is of CN=robot1, and this host is \"robot7\" in site.toml: a copy of another's?");
}

TEST_F(Check, AnotherTeamsPermissionsAreNamedForWritingAndReading) {
  expected_.robot = "robot2";

  const auto all = problems();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_NE(all[0].find("they do not let it write in the team of \"robot2\""), std::string::npos) << all[0];
  EXPECT_NE(all[1].find("they do not let it read in the team of \"robot2\""), std::string::npos) << all[1];
}

TEST_F(Check, ATopicThatIsNotInThePermissionsIsNamed) {
  expected_.publishes = {"robot_pose", "base_status", "scan"};

  EXPECT_TRUE(problem().starts_with("permissions.p7s: they do not let it write: base_status scan. Is site.toml's role"))
      << problem();
}

TEST_F(Check, ADomainThatNobodySignedForIsNamed) {
  expected_.domain = 200;

  const auto all = problems();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_NE(all[0].find("governance.p7s: not for DDS domain 200"), std::string::npos) << all[0];
  EXPECT_NE(all[1].find("permissions.p7s: not for DDS domain 200"), std::string::npos) << all[1];
}

TEST_F(Check, PermissionsTooLongForTheHandshakeAreNamed) {
  const std::vector<std::string> many(200, "robot_pose");
  make_host_files(lab_.path(), "robot1", {"", "robot1", many, {"team_plan"}, kAYear});

  EXPECT_NE(problem().find("and no more than 4700 can be shown to another host"), std::string::npos) << problem();
}

TEST_F(Check, FilesThatHoldSomethingElseAreNamed) {
  write_file_atomically(files_.certificate, "hello\n");
  write_private_file(files_.key, "hello\n");

  EXPECT_EQ(problems(),
            (std::vector<std::string>{files_.certificate.string() + ": no certificate (PEM) in it",
                                      files_.key.string() + ": no private key (PEM, without password) in it"}));
}

TEST_F(Check, AnAuthorityIsNotMadeTwice) {
  EXPECT_THROW(make_authority(lab_.path(), kAYear), std::runtime_error);
}

TEST_F(Check, KeysAreTheirOwnersAlone) {
  const auto mode = [](const fs::path& file) { return fs::status(file).permissions(); };

  EXPECT_EQ(mode(files_.key), fs::perms{0600});
  EXPECT_EQ(mode(lab_ / "authority.key"), fs::perms{0600});
}

}  // namespace
}  // namespace tandem::security
