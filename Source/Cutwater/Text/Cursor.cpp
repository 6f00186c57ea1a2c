#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Text/Cursor.hpp>

namespace cutwater::text {

namespace {

std::string located(const std::string& name, const Place& where, const std::string& message) {
  const char* unit = where.unit == Place::Unit::Line ? ": line " : ": byte ";
  return name + unit + std::to_string(where.value) + ": " + message;
}

}  // namespace

void Cursor::failAt(const Place& where, const std::string& message) const {
  throw Error(ErrorKind::File, located(content_->name, where, message));
}

void Cursor::failLimit(const std::string& message) const {
  throw Error(ErrorKind::Limit, located(content_->name, place(), message));
}

std::uint64_t Cursor::requireRecords(std::int64_t count, std::uint64_t smallestRecord,
                                     const char* what) const {
  if (count < 0) fail("the number of " + std::string(what) + " is " + std::to_string(count));
  const auto records = static_cast<std::uint64_t>(count);
  if (smallestRecord > 0 && records > (bytesLeft() + 1) / smallestRecord) {
    fail("the file promises " + std::to_string(records) + " " + what + ", but only " +
         std::to_string(bytesLeft()) + " bytes are left");
  }
  return records;
}

}  // namespace cutwater::text
