"""Errors: one class for each code of Aktina's table (base/error.cpp), all of them `aktina.Error`."""


class Error(Exception):
    """A user's mistake: what went wrong, where, and what to do, in one line.

    `code`: the word that reports use ("bad_param"). `where`: file, line or parameter, may be empty.
    `hint`: what the user can do, may be empty.

    >>> import aktina
    >>> try:
    ...     aktina.illuminate("fong", {}, [0, 0, 1], [0, 0, 1])
    ... except aktina.Error as error:
    ...     print(error.code, "|", error.where)
    no_such_method | fong
    """

    code = ""

    def __init__(self, message, where="", hint=""):
        text = f"{where}: {message}" if where else message
        super().__init__(f"{text} ({hint})" if hint else text)
        self.message = message
        self.where = where
        self.hint = hint

    def __reduce__(self):
        return type(self), (self.message, self.where, self.hint)


class UsageError(Error, ValueError):
    """A wrong argument: its shape, its name, its type."""

    code = "usage"


class BadParam(Error, ValueError):
    """A parameter outside its accepted range."""

    code = "bad_param"


class NoSuchMethod(Error, ValueError):
    """A method's name that the catalogue does not hold."""

    code = "no_such_method"


class BadInput(Error, ValueError):
    """A file that cannot be understood."""

    code = "bad_input"


class FileError(Error, OSError):
    """A file that cannot be read or written."""

    code = "io"


class LimitExceeded(Error, MemoryError):
    """More memory or work than is allowed."""

    code = "limit"


class CheckFailed(Error):
    """A comparison or validation that did not hold, or a computation that did not converge."""

    code = "check_failed"


class Unsupported(Error):
    """Understood, but not something that Aktina does."""

    code = "unsupported"


class Cancelled(Error):
    """Stopped by the caller."""

    code = "cancelled"


for _class in (Error, *Error.__subclasses__()):
    _class.__module__ = "aktina"
del _class
