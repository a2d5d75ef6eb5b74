#include "robot/motion/npz.h"

#include <zlib.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <stdexcept>

#include "common/text/printable.h"

namespace twinbus::inline robot {

void refuse_npz(const std::string& where, const std::string& what) {
  throw std::runtime_error(where + ": " + what);
}

namespace {

constexpr std::size_t kMostUnpacked = std::size_t{1} << 30;
constexpr std::size_t kMostMembers = 1000;
constexpr std::size_t kEndRecord = 22, kEntry = 46,
                      kLocal = 30;  // fixed parts of a zip archive [bytes]
constexpr std::size_t kLongestComment = 65535;

static_assert(std::endian::native == std::endian::little,
              "numbers are taken as they lie in the file");

template <class Number>
Number number_at(std::string_view bytes, std::size_t at, const std::string& where) {
  if (at > bytes.size() || bytes.size() - at < sizeof(Number)) refuse_npz(where, "is cut short");
  Number number;
  std::memcpy(&number, bytes.data() + at, sizeof number);
  return number;
}

std::string_view part(std::string_view bytes, std::size_t at, std::size_t size,
                      const std::string& where) {
  if (at > bytes.size() || bytes.size() - at < size) refuse_npz(where, "is cut short");
  return bytes.substr(at, size);
}

std::string inflate_member(std::string_view packed, std::size_t size, const std::string& where) {
  std::string out(size, '\0');
  z_stream stream{};
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) refuse_npz(where, "cannot be unpacked");
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  const int result = inflate(&stream, Z_FINISH);
  const std::size_t got = stream.total_out;
  inflateEnd(&stream);
  if (result != Z_STREAM_END || got != size)
    refuse_npz(where, "is damaged: it does not unpack to the size that it says");
  return out;
}

// The value of 'key': in the header, a Python dictionary.
std::string_view value_of(std::string_view header, std::string_view key, const std::string& where) {
  const std::size_t found = header.find("'" + std::string(key) + "':");
  if (found == std::string_view::npos)
    refuse_npz(where, "has a header without '" + std::string(key) + "'");
  std::string_view rest = header.substr(found + key.size() + 3);
  while (!rest.empty() && rest.front() == ' ') rest.remove_prefix(1);
  return rest;
}

double half(std::uint16_t bits) {
  const int exponent = bits >> 10 & 31, fraction = bits & 1023;
  const double sign = (bits & 0x8000) != 0 ? -1.0 : 1.0;
  if (exponent == 31) return fraction != 0 ? std::nan("") : sign * HUGE_VAL;
  return sign *
         (exponent == 0 ? std::ldexp(fraction, -24) : std::ldexp(1024 + fraction, exponent - 25));
}

double read_number(char kind, std::size_t width, const char* from) {
  const auto as = [&](auto number) {
    std::memcpy(&number, from, sizeof number);
    return static_cast<double>(number);
  };
  if (kind == 'f')
    return width == 8   ? as(double{})
           : width == 4 ? as(float{})
                        : half(static_cast<std::uint16_t>(as(std::uint16_t{})));
  if (kind == 'i')
    return width == 8   ? as(std::int64_t{})
           : width == 4 ? as(std::int32_t{})
           : width == 2 ? as(std::int16_t{})
                        : as(std::int8_t{});
  return width == 8   ? as(std::uint64_t{})
         : width == 4 ? as(std::uint32_t{})
         : width == 2 ? as(std::uint16_t{})
                      : as(std::uint8_t{});
}

// Fixed-width text of numpy: S has bytes, U code points of four bytes; zeros fill it up.
std::string read_text(char kind, std::size_t width, const char* from) {
  std::string text;
  for (std::size_t i = 0; i < width; i += kind == 'U' ? 4 : 1) {
    std::uint32_t point = static_cast<unsigned char>(from[i]);
    if (kind == 'U') std::memcpy(&point, from + i, 4);
    if (point == 0) break;
    text += point < 128 ? static_cast<char>(point) : '?';
  }
  return text;
}

NpyArray parse_npy(const std::string& name, std::string_view bytes, const std::string& where) {
  if (!bytes.starts_with("\x93NUMPY")) refuse_npz(where, "is no array of numpy");
  const bool long_header = number_at<std::uint8_t>(bytes, 6, where) >= 2;
  const std::size_t length = long_header ? number_at<std::uint32_t>(bytes, 8, where)
                                         : number_at<std::uint16_t>(bytes, 8, where);
  const std::size_t start = long_header ? 12 : 10;
  const std::string_view header = part(bytes, start, length, where);
  const std::string_view data = bytes.substr(start + length);
  const std::string_view type = value_of(header, "descr", where);
  const std::size_t quote = type.find('\'', 1);
  if (!type.starts_with('\'') || quote == std::string_view::npos || quote < 3 || quote > 12)
    refuse_npz(where, "has a type of several fields; save plain arrays of numbers");
  const std::string descr(type.substr(1, quote - 1));
  const char order = descr[0], kind = descr[1];
  if (kind == 'O')
    refuse_npz(where,
         "holds Python objects, which are not read; save arrays of numbers, and names as text");
  std::size_t width = 0;
  for (const char c : descr.substr(2)) {
    if (c < '0' || c > '9')
      refuse_npz(where, "has the type " + printable(descr, 20) + ", which is not known");
    width = 10 * width + static_cast<std::size_t>(c - '0');
  }
  if (kind == 'U') width *= 4;
  const bool text = kind == 'U' || kind == 'S';
  const bool number = (kind == 'f' && (width == 8 || width == 4 || width == 2)) ||
                      ((kind == 'i' || kind == 'u' || kind == 'b') &&
                       (width == 8 || width == 4 || width == 2 || width == 1));
  if (!(text && width > 0 && width <= 4096) && !number)
    refuse_npz(where,
         "has the type " + printable(descr, 20) + ", which is not known; float32 and float64 are");
  if (order == '>' && width > 1)
    refuse_npz(where, "is big-endian; save it as float32 or float64 of this machine");
  if (!value_of(header, "fortran_order", where).starts_with("False"))
    refuse_npz(where, "is in Fortran order; save numpy.ascontiguousarray of it");
  NpyArray array;
  array.name = name;
  std::string_view shape = value_of(header, "shape", where);
  const std::size_t end = shape.find(')');
  if (!shape.starts_with('(') || end == std::string_view::npos) refuse_npz(where, "has no shape");
  std::size_t count = 1;
  bool digits = false;
  std::size_t dimension = 0;
  for (const char c : shape.substr(1, end)) {
    if (c >= '0' && c <= '9') {
      dimension = 10 * dimension + static_cast<std::size_t>(c - '0');
      digits = true;
      if (dimension > kMostUnpacked) refuse_npz(where, "says a shape that is too large");
    } else if (digits && (c == ',' || c == ')')) {
      array.shape.push_back(dimension);
      count = dimension != 0 && count > kMostUnpacked / dimension ? kMostUnpacked + 1
                                                                  : count * dimension;
      dimension = 0;
      digits = false;
    }
  }
  if (count > kMostUnpacked || data.size() / width < count)
    refuse_npz(where, "says more numbers than it has");
  for (std::size_t i = 0; i < count; ++i) {
    const char* from = data.data() + i * width;
    if (text) {
      array.texts.push_back(read_text(kind, width, from));
    } else {
      array.numbers.push_back(read_number(kind == 'b' ? 'u' : kind, width, from));
    }
  }
  return array;
}

}  // namespace

std::size_t NpyArray::size() const {
  std::size_t count = 1;
  for (const std::size_t d : shape) count *= d;
  return count;
}

std::vector<NpyArray> read_npz(const std::string& file, std::string_view bytes) {
  const std::size_t earliest =
      bytes.size() > kEndRecord + kLongestComment ? bytes.size() - kEndRecord - kLongestComment : 0;
  const std::size_t end = bytes.rfind("PK\x05\x06");
  if (end == std::string_view::npos || end < earliest)
    refuse_npz(file, "is cut short: the end of the archive is missing");
  const std::size_t members = number_at<std::uint16_t>(bytes, end + 10, file);
  std::size_t at = number_at<std::uint32_t>(bytes, end + 16, file);
  if (members > kMostMembers) refuse_npz(file, "has more than 1000 members");
  std::vector<NpyArray> arrays;
  std::size_t unpacked = 0;
  for (std::size_t m = 0; m < members; ++m) {
    if (part(bytes, at, 4, file) != "PK\x01\x02")
      refuse_npz(file, "is damaged: its list of members breaks off");
    const auto method = number_at<std::uint16_t>(bytes, at + 10, file);
    const auto checksum = number_at<std::uint32_t>(bytes, at + 16, file);
    const std::size_t packed = number_at<std::uint32_t>(bytes, at + 20, file);
    const std::size_t size = number_at<std::uint32_t>(bytes, at + 24, file);
    const std::size_t name_size = number_at<std::uint16_t>(bytes, at + 28, file);
    const std::size_t skip = number_at<std::uint16_t>(bytes, at + 30, file) +
                             std::size_t{number_at<std::uint16_t>(bytes, at + 32, file)};
    const std::size_t local = number_at<std::uint32_t>(bytes, at + 42, file);
    std::string name(part(bytes, at + kEntry, name_size, file));
    at += kEntry + name_size + skip;
    if (!name.ends_with(".npy")) continue;
    name.resize(name.size() - 4);
    const std::string where = file + ": " + printable(name, 60);
    if (packed == UINT32_MAX || size == UINT32_MAX || (unpacked += size) > kMostUnpacked)
      refuse_npz(where, "is more than 1 GB unpacked");
    if (part(bytes, local, 4, where) != "PK\x03\x04")
      refuse_npz(where, "is damaged: it is not where the archive says");
    const std::size_t data = local + kLocal + number_at<std::uint16_t>(bytes, local + 26, where) +
                             number_at<std::uint16_t>(bytes, local + 28, where);
    const std::string_view raw = part(bytes, data, packed, where);
    std::string plain;
    if (method == 0 && packed == size) {
      plain = raw;
    } else if (method == 8) {
      plain = inflate_member(raw, size, where);
    } else {
      refuse_npz(where, "is packed by a method that is not known; save it with numpy.savez");
    }
    const uLong sum =
        crc32(0, reinterpret_cast<const Bytef*>(plain.data()), static_cast<uInt>(plain.size()));
    if (sum != checksum) refuse_npz(where, "is damaged: its checksum is wrong");
    arrays.push_back(parse_npy(name, plain, where));
  }
  return arrays;
}

}  // namespace twinbus::robot
