"""Bytes written as hexadecimal digits."""

from s7check.importing.errors import SourceError

_DIGITS = frozenset(b"0123456789abcdefABCDEF")


def decode(content: bytes) -> bytes:
    """``content``, decoded if it is nothing but digits with white space and ``16#`` between them."""
    # Digits from a web page or a forum have no-break spaces between them.
    packed = b"".join(content.replace(b"16#", b" ").replace(b"\xc2\xa0", b" ").split())
    if not packed or not _DIGITS.issuperset(packed):
        return content
    if len(packed) % 2:
        raise SourceError("", "two hexadecimal digits a byte", f"{len(packed)} digits")
    return bytes.fromhex(packed.decode())
