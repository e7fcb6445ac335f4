#include "services/security/check.hpp"

#include <openssl/err.h>
#include <sys/stat.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <stdexcept>

#include "services/common/file_io.hpp"
#include "services/common/format.hpp"
#include "services/security/documents.hpp"
#include "services/security/openssl.hpp"

namespace tandem::security {
namespace {

namespace fs = std::filesystem;

/// What Fast DDS takes along in the handshake's datagram (services/bus/participant_qos.hpp), less the rest of it
/// [bytes].
constexpr std::size_t kMostShown = 4700;

/// Fast DDS matches topics as the shell matches file names; only the star alone is of use here.
bool names(const std::vector<std::string>& patterns, const std::string& name) {
  return std::any_of(patterns.begin(), patterns.end(),
                     [&](const std::string& pattern) { return pattern == name || pattern == "*"; });
}

int number_in(const std::string& text, int otherwise) {
  int number = otherwise;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

bool covers(const std::string& domains_xml, int domain) {
  const auto is_domain = [&](const std::string& id) { return id == std::to_string(domain); };
  const auto ids = texts_of(domains_xml, "id");
  if (std::any_of(ids.begin(), ids.end(), is_domain)) return true;
  const auto ranges = texts_of(domains_xml, "id_range");
  return std::any_of(ranges.begin(), ranges.end(), [&](const std::string& range) {
    return number_in(element_of(range, "min"), 0) <= domain &&
           domain <= number_in(element_of(range, "max"), std::numeric_limits<int>::max());
  });
}

class Examination {
 public:
  Examination(const SecurityFiles& files, const Expected& expected, Time now)
      : files_(files), expected_(expected), now_(now) {}

  std::vector<std::string> problems() {
    const auto authority = text_of_file(files_.authority);
    const auto certificate = text_of_file(files_.certificate);
    const auto key = text_of_file(files_.key);
    const auto governance = text_of_file(files_.governance);
    const auto permissions = text_of_file(files_.permissions);
    if (!problems_.empty()) return std::move(problems_);
    examine_mode();
    examine_certificates(*authority, *certificate, *key);
    if (!problems_.empty()) return std::move(problems_);
    if (const auto shown = certificate->size() + permissions->size(); shown > kMostShown) {
      add(files_.permissions,
          formatted("with the certificate they have %zu bytes, and no more than %zu can be shown to "
                    "another host; fewer topics, or ",
                    shown, kMostShown) +
              remake());
    }
    examine_governance(*governance, *authority);
    examine_permissions(*permissions, *authority, subject_of(*certificate));
    return std::move(problems_);
  }

 private:
  void add(const fs::path& file, const std::string& problem) { problems_.push_back(file.string() + ": " + problem); }
  [[nodiscard]] std::string remake() const {
    return "make this host's files again: tandem secure add " + expected_.host;
  }

  std::optional<std::string> text_of_file(const fs::path& file) {
    try {
      return read_file(file);
    } catch (const FileError& error) {
      problems_.push_back(std::string{error.what()} + ". Copy here what tandem secure add " + expected_.host + " made");
      return std::nullopt;
    }
  }

  void examine_mode() {
    struct stat status {};
    if (stat(files_.key.c_str(), &status) != 0 || (status.st_mode & 077) == 0) return;
    add(files_.key, formatted("others may read it (mode %03o); if they could, make a new one. Then: chmod 600 %s",
                              status.st_mode & 0777U, files_.key.c_str()));
  }

  void examine_time(const fs::path& file, const Validity& validity) {
    const auto say = [&](const char* what, Time limit) {
      add(file, formatted("%s %s UTC, and it is %s UTC now. Is this machine's clock right? If so, %s", what,
                          text_of(limit).c_str(), text_of(now_).c_str(), remake().c_str()));
    };
    if (now_ < validity.begins) say("not valid before", validity.begins);
    if (now_ > validity.ends) say("expired at", validity.ends);
  }

  void examine_certificates(const std::string& authority_pem, const std::string& certificate_pem,
                            const std::string& key_pem) {
    const auto authority = openssl::certificate_of(authority_pem);
    const auto certificate = openssl::certificate_of(certificate_pem);
    const auto key = openssl::key_of(key_pem);
    if (!authority) add(files_.authority, "no certificate (PEM) in it");
    if (!certificate) add(files_.certificate, "no certificate (PEM) in it");
    if (!key) add(files_.key, "no private key (PEM, without password) in it");
    if (!authority || !certificate || !key) return;

    examine_time(files_.authority, {openssl::begin_of(authority.get()), openssl::end_of(authority.get())});
    examine_time(files_.certificate, {openssl::begin_of(certificate.get()), openssl::end_of(certificate.get())});
    if (X509_check_private_key(certificate.get(), key.get()) != 1) {
      add(files_.key, "not the key of " + files_.certificate.filename().string() + "; " + remake());
    }
    if (X509_verify(certificate.get(), X509_get0_pubkey(authority.get())) != 1) {
      add(files_.certificate, "not signed by the authority in " + files_.authority.filename().string() +
                                  ": files of two authorities are mixed. Take all of them from one authority's folder");
    }
    if (const auto subject = subject_of(certificate_pem); subject != "CN=" + expected_.host) {
      add(files_.certificate,
          "it is of " + subject + ", and this host is \"" + expected_.host + "\" in site.toml: a copy of another's?");
    }
    ERR_clear_error();
  }

  std::optional<std::string> signed_text(const fs::path& file, const std::string& document,
                                         const std::string& authority_pem) {
    auto text = verified_document(document, authority_pem);
    ERR_clear_error();
    if (!text) {
      add(file, "not signed by the authority in " + files_.authority.filename().string() + ", or changed afterwards; " +
                    remake());
    }
    return text;
  }

  void examine_domain(const fs::path& file, const std::string& xml) {
    if (covers(element_of(xml, "domains"), expected_.domain)) return;
    add(file, formatted("not for DDS domain %d, link_domain in site.toml; ", expected_.domain) + remake());
  }

  void examine_governance(const std::string& document, const std::string& authority_pem) {
    const auto xml = signed_text(files_.governance, document, authority_pem);
    if (!xml) return;
    examine_domain(files_.governance, *xml);
    // The relay drops whatever comes in the clear (services/bus/core/rtps_guard.hpp).
    for (const char* kind : {"discovery_protection_kind", "liveliness_protection_kind", "metadata_protection_kind"}) {
      if (const auto value = element_of(*xml, kind); value != "ENCRYPT") {
        add(files_.governance, formatted("%s is \"%s\", and hosts take only what is encrypted; make a new authority: "
                                         "tandem secure init",
                                         kind, value.c_str()));
      }
    }
  }

  void examine_permissions(const std::string& document, const std::string& authority_pem, const std::string& subject) {
    const auto xml = signed_text(files_.permissions, document, authority_pem);
    if (!xml) return;
    if (const auto granted = element_of(*xml, "subject_name"); granted != subject) {
      add(files_.permissions, "they are for the subject \"" + granted + "\", and this host's certificate has \"" +
                                  subject + "\"; " + remake());
    }
    try {
      examine_time(files_.permissions,
                   {time_of(element_of(*xml, "not_before")), time_of(element_of(*xml, "not_after"))});
    } catch (const std::runtime_error& error) {
      add(files_.permissions, error.what());
    }
    const std::string rule = element_of(*xml, "allow_rule");
    examine_domain(files_.permissions, rule);
    examine_topics(element_of(rule, "publish"), "write", expected_.publishes);
    examine_topics(element_of(rule, "subscribe"), "read", expected_.subscribes);
  }

  void examine_topics(const std::string& criteria, const char* what, const std::vector<std::string>& topics) {
    if (topics.empty()) return;
    if (const auto teams = texts_of(criteria, "partition"); !names(teams, expected_.robot)) {
      add(files_.permissions, formatted("they do not let it %s in the team of \"%s\" (robot in site.toml); ", what,
                                        expected_.robot.c_str()) +
                                  remake() + " --robot " + expected_.robot);
    }
    std::string missing;
    const auto allowed = texts_of(criteria, "topic");
    for (const auto& topic : topics) {
      if (!names(allowed, topic)) missing += " " + topic;
    }
    if (missing.empty()) return;
    add(files_.permissions,
        formatted("they do not let it %s:%s. Is site.toml's role the one they were made for, and are "
                  "they of this version? If not, ",
                  what, missing.c_str()) +
            remake());
  }

  const SecurityFiles& files_;
  const Expected& expected_;
  Time now_;
  std::vector<std::string> problems_;
};

}  // namespace

std::vector<std::string> problems_of(const SecurityFiles& files, const Expected& expected, Time now) {
  return Examination{files, expected, now}.problems();
}

Time end_of(const SecurityFiles& files) {
  const auto authority = openssl::certificate_of(read_file(files.authority));
  const auto certificate = openssl::certificate_of(read_file(files.certificate));
  openssl::check(authority && certificate, "read a certificate");
  const auto permissions = verified_document(read_file(files.permissions), openssl::pem_of(authority.get()));
  openssl::check(permissions.has_value(), "verify the permissions");
  return std::min({openssl::end_of(authority.get()), openssl::end_of(certificate.get()),
                   time_of(element_of(*permissions, "not_after"))});
}

}  // namespace tandem::security
