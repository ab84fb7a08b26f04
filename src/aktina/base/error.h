// A user's mistake is an Error: what went wrong, where, and what to do, in one line.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace aktina {

enum class Code {
  usage,           // a wrong command line or argument
  bad_param,       // a parameter outside its accepted range
  no_such_method,  // a method name that the catalogue does not hold
  bad_input,       // a file that cannot be understood
  io,              // a file that cannot be read or written
  limit,           // more memory or work than is allowed
  check_failed,    // a comparison or validation that did not hold; not converged
  unsupported,     // understood, but not something Aktina does
  cancelled,       // stopped by the caller
};

/// One table for every face of Aktina: exit status of the program, class in Python, status over HTTP.
struct CodeInfo {
  Code code;
  std::string_view name;          // "bad_input", as in JSON
  int exit_status;                // of the program
  std::string_view python_class;  // subclass of aktina.Error
  int http_status;
};
const CodeInfo& info(Code code);

/// Text: "where: what (hint)", without line breaks or control characters.
class Error : public std::runtime_error {
 public:
  /// @param where  file, line, JSON pointer or parameter; may be empty
  /// @param hint   what the user can do; may be empty
  Error(Code code, std::string where, std::string what, std::string hint = {});

  Code code() const { return code_; }
  const std::string& where() const { return where_; }
  const std::string& message() const { return message_; }
  const std::string& hint() const { return hint_; }

 private:
  Code code_;
  std::string where_, message_, hint_;
};

/// The same text on one line of valid UTF-8: control characters and line breaks become blanks, bytes that are no UTF-8
/// become U+FFFD, very long text is cut.
std::string one_line(std::string_view text);

}  // namespace aktina
