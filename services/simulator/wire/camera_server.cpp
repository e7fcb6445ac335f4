#include "services/simulator/wire/camera_server.hpp"

#include <algorithm>
#include <opencv2/core/mat.hpp>
#include <opencv2/imgcodecs.hpp>

namespace tandem::simulator {
namespace {

constexpr std::string_view kBoundary = "tandem-picture";
constexpr std::size_t kLongestRequest = 8192;

}  // namespace

CameraServer::CameraServer(const std::string& address, std::uint16_t port, Duration period, Time now)
    : listener_(address, port, "the camera (MJPEG)", "camera_port"), period_(period), next_(now) {}

void CameraServer::receive() {
  constexpr std::size_t kMostClients = 8;
  while (clients_.size() < kMostClients) {
    auto connection = listener_.accept();
    if (!connection) break;
    clients_.push_back({std::move(*connection), {}, false});
  }
  for (auto& client : clients_) {
    const auto bytes = client.connection.read();
    client.connection.flush();
    if (client.watching) continue;
    client.request.append(bytes.begin(), bytes.end());
    if (client.request.find("\r\n\r\n") != std::string::npos) answer(client);
    if (client.request.size() > kLongestRequest) client.connection.close();
  }
  std::erase_if(clients_, [](const Client& client) { return !client.connection.is_open(); });
}

void CameraServer::answer(Client& client) {
  if (client.request.starts_with("GET /stream.mjpeg ")) {
    client.connection.write(
        "HTTP/1.0 200 OK\r\nCache-Control: no-store\r\nConnection: close\r\n"
        "Content-Type: multipart/x-mixed-replace; boundary=" +
        std::string{kBoundary} + "\r\n\r\n");
    client.watching = true;
    return;
  }
  client.connection.write("HTTP/1.0 404 Not Found\r\nContent-Length: 0\r\nConnection: close\r\n\r\n");
  client.connection.close();
}

void CameraServer::step(const Simulation& simulation, Time now) {
  if (now < next_) return;
  next_ = std::max(next_ + period_, now);
  const bool watched = std::any_of(clients_.begin(), clients_.end(), [](const Client& client) {
    return client.watching && client.connection.waiting() == 0;
  });
  if (!watched) return;
  const auto jpeg = jpeg_of(simulation.picture());
  const std::string head = "--" + std::string{kBoundary} +
                           "\r\nContent-Type: image/jpeg\r\nContent-Length: " + std::to_string(jpeg.size()) +
                           "\r\n\r\n";
  for (auto& client : clients_) {
    if (!client.watching || client.connection.waiting() > 0) continue;
    client.connection.write(head);
    client.connection.write(jpeg);
    client.connection.write("\r\n");
  }
}

void CameraServer::add_descriptors(std::vector<int>& descriptors) const {
  descriptors.push_back(listener_.descriptor());
  for (const auto& client : clients_) descriptors.push_back(client.connection.descriptor());
}

std::vector<std::uint8_t> jpeg_of(const Picture& picture) {
  const cv::Mat pixels{picture.height_px, picture.width_px, CV_8UC3,
                       const_cast<std::uint8_t*>(picture.bgr.data())};  // NOLINT: cv::Mat does not write to it here
  std::vector<std::uint8_t> jpeg;
  cv::imencode(".jpg", pixels, jpeg, {cv::IMWRITE_JPEG_QUALITY, 90});
  return jpeg;
}

}  // namespace tandem::simulator
