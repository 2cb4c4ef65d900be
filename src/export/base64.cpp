#include "export/base64.hpp"

#include "text/base64.hpp"

namespace zenosphere {

void Base64::write(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t piece = 3 << 12;  // a multiple of three needs no padding between pieces
  waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
  if (waiting_.size() < piece) return;
  const std::size_t whole = waiting_.size() / piece * piece;
  file_.write(base64({waiting_.data(), whole}));
  waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(whole));
}

void Base64::close() {
  file_.write(base64(waiting_));
  waiting_.clear();
}

}  // namespace zenosphere
