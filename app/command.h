// What a subcommand says about itself. Parsing, help, man page and shell completion read only this.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace aktina::app {

class Session;

enum class Kind : uint8_t {
  flag,    // no value
  text,    //
  file,    // a path; completed by the shell
  number,  // within [min, max]
  whole,   // a whole number within [min, max]
  choice,  // one of `choices`
  method,  // METHOD or METHOD:parameter=number,... of the catalogue's `family`, or one of `choices`
};

struct Option {
  std::string_view name;  // "output": --output
  std::string_view help;
  Kind kind = Kind::flag;
  std::string_view value = {};     // what its value is called: "FILE", "WxH"
  std::string_view fallback = {};  // the value where it is not given
  char letter = 0;                 // 'o': -o
  double min = -std::numeric_limits<double>::max(), max = std::numeric_limits<double>::max();
  std::span<const std::string_view> choices = {};
  std::string_view family = {};
  std::string_view implied = {};  // the value where only the name is given: --progress means --progress=bar
  bool required = false;
  bool several = false;        // may be given more than once
  bool affects_result = true;  // recorded in the outputs as part of the settings
};

struct Example {
  std::string_view what, line;
};

/// The values of one call, each checked against its Option. Asking for a name that the command does not have is a
/// mistake of ours and throws std::logic_error.
class Arguments {
 public:
  bool given(std::string_view name) const { return find(name).given; }  // on the command line
  const std::string& text(std::string_view name) const;                 // given or fallback; empty: neither
  const std::vector<std::string>& all(std::string_view name) const { return find(name).texts; }
  double number(std::string_view name) const;
  int64_t whole(std::string_view name) const;

  struct Value {
    const Option* option;
    std::vector<std::string> texts;
    bool given = false;
  };
  std::vector<Value> values;  // inputs, then options, in the command's order

 private:
  const Value& find(std::string_view name) const;
};

struct Command {
  std::string_view name;
  std::string_view summary;         // a few words
  std::string_view description;     // a paragraph or two
  std::span<const Option> inputs;   // positional, in order; `value` names them
  std::span<const Option> options;  // its own; all_options() has the common ones too
  bool long_work;                   // takes --progress and --threads
  std::span<const Example> examples;
  int (*run)(const Arguments&, Session&);  // exit status
};

/// All subcommands: the only list.
std::span<const Command* const> commands();

/// The command's own options and those that all take: --json, --quiet; with long work --progress and --threads.
std::vector<const Option*> all_options(const Command& command);

/// @throws Error usage
Arguments parse(const Command& command, std::span<const char* const> words);

/// What affects the result as one canonical line: "render room.glb --method path --seed 1". Paths lose their folders.
std::string settings_line(const Command& command, const Arguments& arguments);

/// The known word nearest to a mistyped one; empty where none is near.
std::string_view nearest(std::string_view word, std::span<const std::string_view> known);

// Texts made of the tables above.
std::string help_text();
std::string help_text(const Command& command);
std::string man_page();
std::string completion_script(std::string_view shell);  // bash, zsh or fish

}  // namespace aktina::app
