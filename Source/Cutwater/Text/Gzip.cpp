#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Text/ChunkedBytes.hpp>
#include <Cutwater/Text/Gzip.hpp>

#include <algorithm>
#include <new>

#ifdef CUTWATER_HAS_ZLIB
#define ZLIB_CONST
#include <zlib.h>
#endif

namespace cutwater::text {

bool isGzip(std::string_view bytes) {
  return bytes.starts_with("\x1f\x8b");
}

#ifdef CUTWATER_HAS_ZLIB

namespace {

class Inflation {
 public:
  Inflation(const std::string& name, std::string_view compressed, std::uint64_t maxBytes)
      : name_(name), compressed_(compressed), maxBytes_(maxBytes) {
    constexpr int kExpectGzip = 16;
    if (inflateInit2(&stream_, MAX_WBITS + kExpectGzip) != Z_OK) throw std::bad_alloc();
  }
  ~Inflation() { inflateEnd(&stream_); }
  Inflation(const Inflation&) = delete;
  Inflation& operator=(const Inflation&) = delete;
  Inflation(Inflation&&) = delete;
  Inflation& operator=(Inflation&&) = delete;

  Bytes run() && {
    nextChunk();
    while (step()) {
    }
    finishChunk();
    const std::uint64_t size = output_.size();
    return {std::move(output_).joined(), size};
  }

 private:
  // Inflates as much as there is room for; returns false at the end.
  bool step() {
    constexpr std::size_t kMostAtOnce = std::size_t{1} << 30U;  // zlib counts in 32 bits
    const std::string_view left = compressed_.substr(position_);
    stream_.next_in = reinterpret_cast<const Bytef*>(left.data());
    stream_.avail_in = static_cast<uInt>(std::min(left.size(), kMostAtOnce));
    const int code = inflate(&stream_, Z_NO_FLUSH);
    position_ = static_cast<std::uint64_t>(reinterpret_cast<const char*>(stream_.next_in) -
                                           compressed_.data());
    if (code == Z_MEM_ERROR) throw std::bad_alloc();
    if (code == Z_STREAM_END) return nextMember();
    if (code != Z_OK && code != Z_BUF_ERROR) fail("the gzip stream is corrupt");
    if (stream_.avail_out == 0) {
      finishChunk();
      nextChunk();
    } else if (position_ == compressed_.size()) {
      fail("the gzip stream is truncated");
    }
    return true;
  }

  // gzip files may be joined with cat, and padded with zeros.
  bool nextMember() {
    const std::string_view left = compressed_.substr(position_);
    if (left.find_first_not_of('\0') == std::string_view::npos) return false;
    if (!isGzip(left)) fail("data behind the gzip stream");
    inflateReset(&stream_);
    return true;
  }

  void nextChunk() {
    chunk_ = output_.next();
    stream_.next_out = reinterpret_cast<Bytef*>(chunk_.data);
    stream_.avail_out = static_cast<uInt>(chunk_.size);
  }

  void finishChunk() {
    output_.filled(chunk_.size - stream_.avail_out);
    if (output_.size() <= maxBytes_) return;
    throw Error(ErrorKind::Limit, at() + "the file decompresses to more than the limit of " +
                                      std::to_string(maxBytes_) + " bytes");
  }

  [[nodiscard]] std::string at() const {
    return name_ + ": byte " + std::to_string(position_) + " (compressed): ";
  }
  [[noreturn]] void fail(const char* message) const {
    throw Error(ErrorKind::File, at() + message);
  }

  const std::string& name_;
  std::string_view compressed_;
  std::uint64_t maxBytes_;
  std::uint64_t position_ = 0;
  z_stream stream_{};
  ChunkedBytes output_;
  ChunkedBytes::Chunk chunk_{};
};

}  // namespace

Bytes gunzip(const std::string& name, std::string_view compressed, std::uint64_t maxBytes) {
  return Inflation(name, compressed, maxBytes).run();
}

bool inflateBlock(const std::string& /*name*/, std::string_view compressed, std::span<char> into) {
  char none = 0;  // zlib wants room even for nothing
  auto* const to = reinterpret_cast<Bytef*>(into.empty() ? &none : into.data());
  uLongf size = into.size();
  uLong used = compressed.size();
  const int code = uncompress2(to, &size, reinterpret_cast<const Bytef*>(compressed.data()), &used);
  if (code == Z_MEM_ERROR) throw std::bad_alloc();
  return code == Z_OK && size == into.size() && used == compressed.size();
}

#else

Bytes gunzip(const std::string& name, std::string_view, std::uint64_t) {
  throw Error(ErrorKind::File,
              name + ": byte 0: a gzip-compressed file, and this Cutwater was built without zlib");
}

bool inflateBlock(const std::string& name, std::string_view, std::span<char>) {
  throw Error(ErrorKind::File,
              name + ": byte 0: data compressed by zlib, and this Cutwater was built without zlib");
}

#endif

}  // namespace cutwater::text
