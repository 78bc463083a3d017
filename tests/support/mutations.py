"""Where a C++ source can be mutated, and into what: one operator or constant at a time.

The text is read by tokens, not parsed. It relies on clang-format: a comparison, a product or a
bitwise and stands between blanks, a template bracket, a pointer or a reference does not.
"""

import re

TOKEN = re.compile(r"""
    (?P<comment> //[^\n]* | /\*.*?\*/ )
  | (?P<directive> ^[ \t]*\#(?:[^\n\\]|\\.|\\\n)* )
  | (?P<text> (?:u8|[uUL])?R"(?P<mark>[^(]*)\(.*?\)(?P=mark)" | (?:u8|[uUL])?"(?:[^"\\]|\\.)*"
            | (?:u8|[uUL])?'(?:[^'\\]|\\.)+' )
  | (?P<number> (?:0[xX][\da-fA-F']+ | \d[\d']*(?:\.[\d']*)?(?:[eE][+-]?\d+)? | \.\d+(?:[eE][+-]?\d+)?)
                (?:[uUlLfF]*|_\w+) )
  | (?P<name> [A-Za-z_]\w* )
  | (?P<operator> <=> | <<= | >>= | -> | \+\+ | -- | && | \|\| | == | != | <= | >= | << | >>
                | [-+*/%&|^]= | :: | [-+*/%&|^!~<>=] )
  | (?P<other> \S )
""", re.VERBOSE | re.MULTILINE | re.DOTALL)

BETWEEN_BLANKS = {
    "==": ["!="], "!=": ["=="], "<": ["<=", ">="], "<=": ["<", ">"], ">": [">=", "<="],
    ">=": [">", "<"], "+": ["-"], "-": ["+"], "*": ["/"], "/": ["*"], "%": ["*"],
    "&&": ["||"], "||": ["&&"], "&": ["|"], "|": ["&"], "^": ["&"], "<<": [">>"], ">>": ["<<"],
    "+=": ["-="], "-=": ["+="], "*=": ["/="], "/=": ["*="], "&=": ["|="], "|=": ["&="],
}
BESIDE_ITS_OPERAND = {"!": [""], "-": [""], "~": [""], "++": ["--"], "--": ["++"]}
NAMES = {"true": ["false"], "false": ["true"]}
# A contract only fires in an incorrect program, and a static assertion only while compiling.
NOT_BEHAVIOUR = {"static_assert", "CARINA_EXPECTS"}


class Mutation:
    """Replacing text[start:end] by `new`."""

    def __init__(self, text, start, end, new):
        self.start, self.end, self.old, self.new = start, end, text[start:end], new
        self.line = text.count("\n", 0, start) + 1

    def applied_to(self, text):
        return text[:self.start] + self.new + text[self.end:]


def numbers_beside(literal):
    """The neighbours of a number, as literals of the same type."""
    digits, suffix = re.fullmatch(r"(.*?)([uUlLfF]*|_\w+)", literal).groups()
    if re.match(r"0[xX]", literal):
        digits, suffix = re.fullmatch(r"(0[xX][\da-fA-F']+)([uUlL]*)", literal).groups()
        value = int(digits.replace("'", ""), 16)
        return [f"{number:#x}{suffix}" for number in (value + 1, value - 1) if number >= 0]
    digits = digits.replace("'", "")
    if re.fullmatch(r"\d+", digits):
        value = int(digits, 8 if re.fullmatch(r"0[0-7]+", digits) else 10)
        return [f"{number}{suffix}" for number in (value + 1, value - 1) if number >= 0]
    value = float(digits)
    return [f"{2 * value!r}{suffix}" if value else f"1.0{suffix}"]


def skipped_ranges(text, tokens):
    """Character ranges that are no behaviour: template arguments, contracts, static assertions."""
    ranges = []
    for index, token in enumerate(tokens):
        if index and token[0] == "<" and tokens[index - 1].lastgroup == "name" and not (
                text[token.start() - 1].isspace() and text[token.end()].isspace()):
            ranges.append((token.start(), end_of(tokens, index, "<", ">", ";{")))
        elif token[0] in NOT_BEHAVIOUR:
            ranges.append((token.start(), end_of(tokens, index + 1, "(", ")", "")))
    return ranges


def end_of(tokens, index, opening, closing, giving_up):
    """Where the bracket that opens at tokens[index] closes; where it opens when it never does."""
    depth = 0
    for token in tokens[index:]:
        if token[0] in giving_up:
            break
        if token.lastgroup in ("operator", "other") and token[0] != "->":
            depth += token[0].count(opening) - token[0].count(closing)
        if depth <= 0:
            return token.end()
    return tokens[index].start()


def replacements(text, token):
    """What one token can be mutated into."""
    if token.lastgroup == "number":
        return numbers_beside(token[0])
    if token.lastgroup == "name":
        return NAMES.get(token[0], [])
    if token.lastgroup != "operator":
        return []
    before = text[token.start() - 1:token.start()].isspace()
    after = text[token.end():token.end() + 1].isspace()
    if before and after:
        return BETWEEN_BLANKS.get(token[0], [])
    unary = token[0] in ("++", "--") or not text[token.start() - 1:token.start()].isalnum()
    return BESIDE_ITS_OPERAND.get(token[0], []) if unary and not after else []


def mutations_of(text):
    """Every mutation of a source, in its order."""
    tokens = [token for token in TOKEN.finditer(text)
              if token.lastgroup not in ("comment", "directive")]
    skipped = skipped_ranges(text, tokens)
    found = []
    for index, token in enumerate(tokens):
        if any(start <= token.start() < end for start, end in skipped):
            continue
        if index and tokens[index - 1][0] == "operator":
            continue
        found += [Mutation(text, token.start(), token.end(), new)
                  for new in replacements(text, token)]
    return found
