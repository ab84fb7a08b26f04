// EULUMDAT: one value a line. A. Stockmar, "EULUMDAT: ein Leuchtendatenformat fuer den europaeischen
// Beleuchtungsplaner", Licht '90.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "aktina/base/error.h"
#include "aktina/import/luminaire/luminaire.h"
#include "aktina/import/luminaire/planes.h"
#include "aktina/import/text.h"

namespace aktina {
namespace {

class EulumdatReader {
 public:
  EulumdatReader(std::span<const uint8_t> bytes, const std::string& where)
      : text_(utf8_or_latin1(decode_text(bytes))), lines_(text_), where_(where) {}

  Luminaire run() {
    out_.format = "EULUMDAT";
    out_.manufacturer = line();
    number("type");
    symmetry_ = whole("symmetry", 0, 4);
    planes_ = whole("number of C planes", 1, 721);
    number("distance of C planes");
    gammas_ = whole("number of gamma angles", 2, 361);
    number("distance of gamma angles");
    line();
    out_.name = line();
    for (int i = 0; i < 3; ++i) line();
    for (int i = 0; i < 3; ++i) number("size of the luminaire");
    opening();
    number("downward flux fraction");
    number("light output ratio");
    const double conversion = number("conversion factor");
    number("tilt");
    lamps();
    for (int i = 0; i < 10; ++i) number("direct ratio");
    table(conversion);
    return std::move(out_);
  }

 private:
  void opening() {  // millimetres; a width of 0 is round
    LuminousOpening& o = out_.opening;
    o.length = float(number("length of the luminous area") / 1000);
    o.width = float(number("width of the luminous area") / 1000);
    for (int i = 0; i < 4; ++i) o.height = std::max(o.height, float(number("height of the luminous area") / 1000));
    using Shape = LuminousOpening::Shape;
    if (o.length == 0 && o.width == 0) return;
    o.shape = o.width == 0 ? Shape::ellipse : Shape::rectangle;
    if (o.width == 0) o.width = o.length;
  }
  /// Intensities are for 1000 lm of the first set. A negative number of lamps says that they are measured with it.
  void lamps() {
    const int sets = whole("number of lamp sets", 0, 20);
    for (int i = 0; i < sets; ++i) {
      number("number of lamps");
      const std::string lamp = line();
      const double flux = number("lamp flux");
      line(), line();
      const double watts = number("lamp watts");
      if (i == 0) out_.lamp = lamp, out_.lamp_flux = flux, out_.watts = watts;
    }
    if (sets == 0) {
      out_.lamp_flux = 1000;
      out_.warnings.add("no lamps are stated: intensities are for 1000 lm");
    }
  }

  void table(double conversion) {
    std::vector<float> c, gamma;
    for (int i = 0; i < planes_; ++i) c.push_back(float(number("C angle")));
    for (int i = 0; i < gammas_; ++i) gamma.push_back(float(number("gamma angle")));
    const auto [first, count] = stored();
    auto table = std::make_shared<PhotometricTable>();
    table->gamma = gamma;
    const double factor = (conversion > 0 ? conversion : 1) * out_.lamp_flux / 1000;
    uint64_t negative = 0;
    for (int i = 0; i < count; ++i) {
      table->c.push_back(count == 1 ? 0 : c[size_t(first + i) % c.size()]);
      for (int k = 0; k < gammas_; ++k) {
        const double value = number("intensity") * factor;
        negative += value < 0;
        table->candela.push_back(float(std::max(value, 0.0)));
      }
    }
    out_.warnings.add("negative intensities were taken as 0", negative);
    try {
      unroll(*table);
      out_.symmetry = complete_planes(*table);
      check(*table);
    } catch (const Error& error) {
      fail(error.message());
    }
    out_.table = std::move(table);
  }

  struct Stored {
    int first, count;
  };
  /// Which planes the file holds, by its symmetry. About C90-C270 they run on from C270 through C0 to C90.
  Stored stored() {
    const int m = planes_;
    switch (symmetry_) {
      case 1:
        return {0, 1};
      case 2:
        return {0, m / 2 + 1};
      case 3:
        return {3 * m / 4, m / 2 + 1};
      case 4:
        return {0, m / 4 + 1};
      default:
        return {0, m};
    }
  }
  /// Planes from C270 through C0 to C90 are those from C270 down to C90: the same by the symmetry.
  void unroll(PhotometricTable& table) {
    if (symmetry_ != 3) return;
    const size_t n = table.gamma.size();
    for (float& c : table.c) c = c >= 270 ? 540 - c : 180 - c;  // 270 .. 180 .. 90
    std::reverse(table.c.begin(), table.c.end());
    std::vector<float> candela;
    for (size_t i = table.c.size(); i-- > 0;)
      candela.insert(candela.end(), &table.candela[i * n], &table.candela[i * n] + n);
    table.candela = std::move(candela);
  }

  std::string line() {
    std::string_view text;
    if (!lines_.next(text)) fail("ends too early");
    return std::string(trimmed(text));
  }
  double number(const char* what) {
    std::string text = line();
    std::replace(text.begin(), text.end(), ',', '.');
    std::string_view rest = text;
    const std::string_view word = next_word(rest);
    double value = 0;
    if (word.empty()) return 0;  // left out, as makers do
    if (!parse_number(word, value) || !std::isfinite(value))
      fail(fmt::format("{} is '{}', not a number", what, word.substr(0, 40)));
    return value;
  }
  int whole(const char* what, int least, int most) {
    const double value = number(what);
    if (!(value >= least && value <= most && value == std::floor(value)))
      fail(fmt::format("{} is {}, accepted {} .. {}", what, value, least, most));
    return int(value);
  }
  [[noreturn]] void fail(std::string what) const {
    throw Error(Code::bad_input, place(where_, std::max<size_t>(lines_.number(), 1)), std::move(what));
  }

  std::string text_;
  Lines lines_;
  const std::string& where_;
  int symmetry_ = 0, planes_ = 0, gammas_ = 0;
  Luminaire out_;
};

}  // namespace

Luminaire read_eulumdat(std::span<const uint8_t> bytes, const std::string& where) {
  return EulumdatReader(bytes, where).run();
}

}  // namespace aktina
