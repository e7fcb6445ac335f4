#include "services/cli/topics/topics_view.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "services/common/format.hpp"

namespace tandem::cli {
namespace {

using Row = std::vector<std::string>;

/// Columns as wide as their widest cell, two blanks between them.
void append_table(std::vector<std::string>& lines, const std::vector<Row>& rows) {
  std::vector<std::size_t> widths;
  for (const Row& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  for (const Row& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      line += row[i];
      if (i + 1 < row.size()) line.append(widths[i] - row[i].size() + 2, ' ');
    }
    lines.push_back(line);
  }
}

/// "navigator tracker@robot1, relay@laptop1": services by host.
std::string readers_text(const std::vector<ReaderView>& readers) {
  std::string text;
  for (std::size_t i = 0; i < readers.size(); ++i) {
    text += readers[i].service;
    const bool host_ends = i + 1 == readers.size() || readers[i + 1].host != readers[i].host;
    if (host_ends) text += "@" + readers[i].host;
    if (i + 1 < readers.size()) text += host_ends ? ", " : " ";
  }
  return text.empty() ? "-" : text;
}

Row row_of(const TopicView& topic, const WriterView& writer, bool is_first) {
  return {is_first ? topic.topic : "",
          writer.host,
          writer.service + (writer.alive ? "" : " (gone)"),
          formatted("%.1f", writer.rate_hz),
          writer.age_s ? formatted("%.1f", *writer.age_s) : "-",
          formatted("%.1f", 100.0 * writer.loss()),
          writer.malformed > 0 ? formatted("%llu", static_cast<unsigned long long>(writer.malformed)) : "-",
          is_first ? readers_text(topic.readers) : ""};
}

void append_topics(std::vector<std::string>& lines, const TopicsView& view) {
  std::vector<Row> rows{{"TOPIC", "HOST", "WRITER", "HZ", "AGE_S", "LOSS_%", "BAD", "READERS"}};
  for (const TopicView& topic : view.topics) {
    if (topic.writers.empty() && topic.readers.empty()) continue;
    if (topic.writers.empty()) {
      rows.push_back({topic.topic, "-", "-", "-", "-", "-", "-", readers_text(topic.readers)});
    }
    for (const WriterView& writer : topic.writers) {
      rows.push_back(row_of(topic, writer, &writer == &topic.writers.front()));
    }
  }
  if (rows.size() == 1) {
    lines.push_back("Nobody is here: is the system running, on this DDS domain? See --domain.");
    return;
  }
  append_table(lines, rows);
}

void append_services(std::vector<std::string>& lines, const TopicsView& view) {
  if (view.services.empty()) return;
  std::vector<Row> rows{{"SERVICE", "HOST", "PROCESS", "VERSION", "CONTRACT", "STATE", "REASON"}};
  for (const auto& sign : view.services) {
    rows.push_back({sign.service, sign.host, std::to_string(sign.process_id), sign.version, sign.contract_hash,
                    sign.state, sign.reason});
  }
  lines.emplace_back();
  append_table(lines, rows);
}

}  // namespace

std::vector<std::string> lines_of(const TopicsView& view) {
  std::vector<std::string> lines;
  for (const auto& fault : view.faults) lines.push_back(text_of(fault));
  if (!view.faults.empty()) lines.emplace_back();
  append_topics(lines, view);
  append_services(lines, view);
  return lines;
}

std::string json_of(const TopicsView& view) {
  using Json = nlohmann::ordered_json;
  Json topics = Json::array();
  for (const TopicView& topic : view.topics) {
    Json writers = Json::array();
    for (const WriterView& writer : topic.writers) {
      writers.push_back({{"host", writer.host},
                         {"service", writer.service},
                         {"alive", writer.alive},
                         {"samples", writer.samples},
                         {"rate_hz", writer.rate_hz},
                         {"age_s", writer.age_s ? Json(*writer.age_s) : Json(nullptr)},
                         {"lost", writer.lost},
                         {"loss", writer.loss()},
                         {"malformed", writer.malformed}});
    }
    Json readers = Json::array();
    for (const ReaderView& reader : topic.readers)
      readers.push_back({{"host", reader.host}, {"service", reader.service}});
    topics.push_back({{"topic", topic.topic}, {"writers", writers}, {"readers", readers}});
  }
  Json services = Json::array();
  for (const auto& sign : view.services) {
    services.push_back({{"host", sign.host},
                        {"service", sign.service},
                        {"robot", sign.robot},
                        {"process_id", sign.process_id},
                        {"version", sign.version},
                        {"contract_hash", sign.contract_hash},
                        {"state", sign.state},
                        {"reason", sign.reason}});
  }
  Json faults = Json::array();
  for (const auto& fault : view.faults) faults.push_back({{"id", fault.id}, {"what", fault.what}});
  const Json all{{"watched_s", view.watched_s}, {"topics", topics}, {"services", services}, {"faults", faults}};
  // Names come from strangers: what is not UTF-8 is replaced.
  return all.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace tandem::cli
