#include "campaign/csv.hpp"

namespace zenosphere {

namespace {

std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

}  // namespace

void write_csv(Database& store, const std::function<void(const std::string&)>& write) {
  constexpr std::size_t piece = 1 << 16;
  Statement query = store.statement("SELECT * FROM run ORDER BY run");
  std::string text;
  const auto add_line = [&](auto cell) {
    for (int column = 0; column < query.columns(); ++column) {
      if (column > 0) text += ',';
      text += field(cell(column));
    }
    text += '\n';
  };
  add_line([&](int column) { return query.column_name(column); });
  while (query.step()) {
    add_line([&](int column) { return cell_text(query.cell(column)); });
    if (text.size() < piece) continue;
    write(text);
    text.clear();
  }
  write(text);
}

}  // namespace zenosphere
