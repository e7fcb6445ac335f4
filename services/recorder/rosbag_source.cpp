#include "services/recorder/rosbag_source.hpp"

#include <sqlite3.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <vector>

#include "services/recorder/core/mcap_reader.hpp"
#include "services/recorder/core/ros1_bag.hpp"

namespace tandem::recorder {
namespace {

using OnMessage = std::function<bool(const RosbagMessage&)>;

/// Ends the reading of a bag from inside.
struct Enough {};

struct CloseDatabase {
  void operator()(sqlite3* database) const { sqlite3_close(database); }
};
struct EndStatement {
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};

std::string column_text(sqlite3_stmt* statement, int column) {
  const auto* text = sqlite3_column_text(statement, column);
  return text == nullptr ? "" : reinterpret_cast<const char*>(text);
}

void read_database(const std::filesystem::path& file, const OnMessage& on_message) {
  sqlite3* opened = nullptr;
  const int result = sqlite3_open_v2(file.c_str(), &opened, SQLITE_OPEN_READONLY, nullptr);
  const std::unique_ptr<sqlite3, CloseDatabase> database{opened};
  const auto fail = [&] { throw std::runtime_error(file.string() + ": " + sqlite3_errmsg(database.get())); };
  if (result != SQLITE_OK) fail();
  constexpr const char* kQuery =
      "SELECT topics.name, topics.type, topics.serialization_format, messages.timestamp, messages.data FROM messages "
      "JOIN topics ON messages.topic_id = topics.id ORDER BY messages.timestamp, messages.id";
  sqlite3_stmt* prepared = nullptr;
  if (sqlite3_prepare_v2(database.get(), kQuery, -1, &prepared, nullptr) != SQLITE_OK) fail();
  const std::unique_ptr<sqlite3_stmt, EndStatement> statement{prepared};
  int step = SQLITE_ROW;
  while ((step = sqlite3_step(statement.get())) == SQLITE_ROW) {
    if (column_text(statement.get(), 2) != "cdr") continue;
    const auto* data = static_cast<const std::uint8_t*>(sqlite3_column_blob(statement.get(), 4));
    const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement.get(), 4));
    const RosbagMessage message{column_text(statement.get(), 0),
                                column_text(statement.get(), 1),
                                ros::Wire::Cdr,
                                sqlite3_column_int64(statement.get(), 3),
                                {data, size}};
    if (!on_message(message)) throw Enough{};
  }
  if (step != SQLITE_DONE) fail();
}

void read_mcap(const std::filesystem::path& file, const OnMessage& on_message) {
  mcap::Reader reader{mcap::file_source(file), file.string()};
  for (std::size_t i = 0; i < reader.message_count(); ++i) {
    const mcap::Channel& channel = reader.channels().at(reader.channel_at(i));
    const auto schema = reader.schemas().find(channel.schema_id);
    if (schema == reader.schemas().end() || channel.message_encoding != "cdr") continue;
    if (!ros::is_known(schema->second.name)) continue;
    const auto message = reader.message_at(i);
    if (!message) throw std::runtime_error(reader.damages().back());
    if (!on_message({channel.topic, schema->second.name, ros::Wire::Cdr, static_cast<std::int64_t>(message->log_time),
                     message->data})) {
      throw Enough{};
    }
  }
}

void read_bag(const std::filesystem::path& file, const OnMessage& on_message) {
  const auto source = mcap::file_source(file);
  ros::read_ros1_bag(*source, file.string(), [&on_message](const ros::BagMessage& message) {
    if (!on_message({message.topic, message.type, ros::Wire::Ros1, message.time_ns, message.data})) throw Enough{};
  });
}

void read_one(const std::filesystem::path& file, const OnMessage& on_message) {
  const mcap::Bytes head = mcap::file_source(file)->read(0, 16);
  const std::string text{head.begin(), head.end()};
  if (text.starts_with("#ROSBAG")) return read_bag(file, on_message);
  if (text.starts_with("SQLite format 3")) return read_database(file, on_message);
  if (std::equal(std::begin(mcap::kMagic), std::end(mcap::kMagic), head.begin())) return read_mcap(file, on_message);
  throw std::runtime_error(file.string() + ": is no ROS bag (.bag of ROS 1; .mcap or .db3 of rosbag2, not compressed)");
}

}  // namespace

void read_rosbag(const std::filesystem::path& bag, const OnMessage& on_message) {
  std::vector<std::filesystem::path> files;
  if (std::filesystem::is_directory(bag)) {
    for (const auto& entry : std::filesystem::directory_iterator{bag}) {
      const auto extension = entry.path().extension();
      if (extension == ".mcap" || extension == ".db3" || extension == ".bag") files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    if (files.empty()) throw std::runtime_error(bag.string() + ": has no .mcap, .db3 or .bag in it");
  } else {
    files.push_back(bag);
  }
  try {
    for (const auto& file : files) read_one(file, on_message);
  } catch (const Enough&) {  // the caller has what it wanted
  }
}

}  // namespace tandem::recorder
