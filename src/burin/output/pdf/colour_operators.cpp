#include <cmath>

#include <fmt/format.h>

#include <burin/base/check.hpp>
#include <burin/output/pdf/colour_operators.hpp>
#include <burin/output/pdf/text.hpp>

namespace burin::output::pdf {

namespace {

/// Some readers cut off where they should round: rounded up, each of 255 steps comes back as itself in all of them.
std::string share_text(std::uint8_t of_255) {
  return number_text(std::ceil(of_255 / 255.0 * 1e6) / 1e6);
}

/// A colour's numbers and the letter of its operators: "0" and "g", "1 0 0" and "rg".
struct Numbers {
  std::string numbers;
  std::string name;
  std::string device;
  std::string none;  ///< of no ink at all
};

Numbers numbers_of(Colour colour) {
  if (colour.red == colour.green && colour.green == colour.blue) return {share_text(colour.red), "g", "Gray", "1"};
  return {fmt::format("{} {} {}", share_text(colour.red), share_text(colour.green), share_text(colour.blue)), "rg",
          "RGB", "1 1 1"};
}

Numbers numbers_of(const Cmyk& inks) {
  return {fmt::format("{} {} {} {}", number_text(inks.cyan), number_text(inks.magenta), number_text(inks.yellow),
                      number_text(inks.black)),
          "k", "CMYK", "0 0 0 0"};
}

Numbers numbers_of(const Pen& pen) {
  return pen.cmyk ? numbers_of(*pen.cmyk) : numbers_of(pen.colour);
}

std::string capitals(std::string text) {
  for (char& c : text) c = static_cast<char>(c - 'a' + 'A');
  return text;
}

}  // namespace

std::string fill_operator(Colour colour) {
  const Numbers is = numbers_of(colour);
  return is.numbers + ' ' + is.name;
}

std::string pen_colour_operators(const Pen& pen, std::size_t index) {
  if (!pen.spot.empty()) return fmt::format("/S{0} CS 1 SCN /S{0} cs 1 scn", index);
  const Numbers is = numbers_of(pen);
  return fmt::format("{0} {1} {0} {2}", is.numbers, capitals(is.name), is.name);
}

std::string spot_space(const Pen& pen) {
  BURIN_EXPECT(!pen.spot.empty());
  const Numbers is = numbers_of(pen);
  return fmt::format("[/Separation{}/Device{}<</FunctionType 2/Domain[0 1]/C0[{}]/C1[{}]/N 1>>]", name_text(pen.spot),
                     is.device, is.none, is.numbers);
}

}  // namespace burin::output::pdf
