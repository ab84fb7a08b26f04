"""The compiled core. Called by this package only: its functions take what the package has checked."""
from typing import Any

def __getattr__(name: str) -> Any: ...
