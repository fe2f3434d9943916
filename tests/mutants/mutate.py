"""Mutants of a C file: small slips such as people make, one a mutant, made on the file's tokens.

A tokeniser is enough and better here than a compiler's tree: what a mutant must be is text that compiles,
so the compiler itself sorts out what is no C, and the line of a mutant can be shown as a student would
read it.
"""
import re

TOKEN = re.compile(
    r"(?P<space>\s+|//[^\n]*|/\*.*?\*/|^[ \t]*\#(?:\\\n|[^\n])*)"
    r'|(?P<text>"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])*\')'
    r"|(?P<number>\.?\d(?:[eEpP][+-]|[\w.])*)"
    r"|(?P<word>[A-Za-z_]\w*)"
    r"|(?P<operator><<=|>>=|\.\.\.|->|\+\+|--|<<|>>|<=|>=|==|!=|&&|\|\||[-+*/%&|^]=|.)",
    re.S | re.M,
)

# An operator and what it is mistaken for: a bound that is one off, its negation, its inverse.
OPERATORS = {
    "<": ("<=", ">="), "<=": ("<", ">"), ">": (">=", "<="), ">=": (">", "<"), "==": ("!=",), "!=": ("==",),
    "&&": ("||",), "||": ("&&",), "+": ("-",), "-": ("+",), "*": ("+",), "/": ("*",), "%": ("/",),
    "+=": ("-=",), "-=": ("+=",), "*=": ("+=",), "/=": ("*=",), "++": ("--",), "--": ("++",),
    "<<": (">>",), ">>": ("<<",), "&": ("|",), "|": ("&",), "^": ("&",), "!": ("",), "~": ("",),
}
CONDITIONS = ("<", "<=", ">", ">=", "==", "!=", "&&", "||", "!")
OPEN, CLOSE = "([{", ")]}"


class Token:
    def __init__(self, kind, text, start):
        self.kind, self.text, self.start, self.end = kind, text, start, start + len(text)


class Mutant:
    """One change: source[start:end] becomes `text`."""

    def __init__(self, operator, start, end, text):
        self.operator, self.start, self.end, self.text = operator, start, end, text

    def apply(self, source):
        return source[: self.start] + self.text + source[self.end :]

    def lines(self, source):
        """Number of the changed line, the line before and after, without indentation."""
        first = source.rfind("\n", 0, self.start) + 1
        changed = self.apply(source)
        last, last_changed = source.find("\n", self.end), changed.find("\n", self.start + len(self.text))
        squeeze = lambda text: re.sub(r"\s+", " ", text.strip())
        return source.count("\n", 0, self.start) + 1, squeeze(source[first:last]), squeeze(changed[first:last_changed])


def tokens_of(source):
    return [Token(m.lastgroup, m.group(), m.start()) for m in TOKEN.finditer(source) if m.lastgroup != "space"]


def match_brackets(tokens):
    """Index of the closing token for that of each opening one."""
    partner, stack = {}, []
    for i, token in enumerate(tokens):
        if token.text in OPEN:
            stack.append(i)
        elif token.text in CLOSE and stack:
            partner[stack.pop()] = i
    return partner


def operators(tokens):
    for token in tokens:
        if token.kind == "operator":
            kind = "condition" if token.text in CONDITIONS else "operator"
            for other in OPERATORS.get(token.text, ()):
                yield Mutant(kind, token.start, token.end, other)


def constants(tokens):
    for token in tokens:
        whole = re.fullmatch(r"(0[xX][0-9a-fA-F]+|\d+)([uUlL]*)", token.text)
        if token.kind != "number":
            continue
        if not whole:
            yield Mutant("constant", token.start, token.end, f"({token.text} + 1)")
            continue
        value = int(whole[1], 0)
        for other in (value + 1, value - 1) if value else (1,):
            text = hex(other) if whole[1][:2] in ("0x", "0X") else str(other)
            yield Mutant("constant", token.start, token.end, text + whole[2])


def conditions(source, tokens, partner):
    """The whole condition of an if or a while negated."""
    for i, token in enumerate(tokens[:-1]):
        if token.text in ("if", "while") and tokens[i + 1].text == "(" and i + 1 in partner:
            start, end = tokens[i + 1].end, tokens[partner[i + 1]].start
            yield Mutant("condition", start, end, f"!({source[start:end]})")


def statements(source, tokens, partner):
    """Statements that are left out, but for declarations and the return at a function's end."""
    heads = {partner[i + 1] for i, t in enumerate(tokens) if t.text in ("if", "for", "while") and i + 1 in partner}
    braces = 0
    for i, token in enumerate(tokens):
        braces += (token.text == "{") - (token.text == "}")
        if braces < 1 or not (token.text in (";", "{", "}", "else") or i in heads):
            continue
        end = i + 1
        while end < len(tokens) and tokens[end].text not in (";", "{", "}"):
            end = partner.get(end, end) + 1
        if end >= len(tokens) or tokens[end].text != ";" or end == i + 1:
            continue
        first = tokens[i + 1]
        if first.text in ("if", "for", "while", "do", "else", "case", "default"):
            continue
        closes_function = braces == 1 and end + 1 < len(tokens) and tokens[end + 1].text == "}"
        if first.text == "return" and closes_function:
            continue
        yield Mutant("statement", first.start, tokens[end].end, ";")


def indices(source, tokens, partner):
    """In brackets: another index, and one element further."""
    names = []
    for i, token in enumerate(tokens):
        if token.text == "[" and i in partner:
            names += [t.text for t in tokens[i + 1 : partner[i]] if t.kind == "word" and t.text not in names]
    for i, token in enumerate(tokens):
        if token.text != "[" or partner.get(i, i + 1) == i + 1:
            continue
        start, end = token.end, tokens[partner[i]].start
        yield Mutant("off-by-one", start, end, f"({source[start:end]}) + 1")
        for inner in tokens[i + 1 : partner[i]]:
            if inner.kind == "word":
                for step in (1, 2):
                    other = names[(names.index(inner.text) + step) % len(names)]
                    if other != inner.text:
                        yield Mutant("index", inner.start, inner.end, other)


def arguments(source, tokens, partner):
    """Neighbouring arguments of a call changed for each other."""
    for i, token in enumerate(tokens[:-1]):
        if token.kind != "word" or tokens[i + 1].text != "(" or i + 1 not in partner:
            continue
        cuts, at = [i + 1], i + 2
        while at < partner[i + 1]:
            if tokens[at].text == ",":
                cuts.append(at)
            at = partner.get(at, at) + 1
        cuts.append(partner[i + 1])
        for a, b, c in zip(cuts, cuts[1:], cuts[2:]):
            if b > a + 1 and c > b + 1:
                left, right = (source[tokens[x + 1].start : tokens[y - 1].end] for x, y in ((a, b), (b, c)))
                yield Mutant("arguments", tokens[a + 1].start, tokens[c - 1].end, f"{right}, {left}")


def mutants_of(source):
    """Every mutant of a C file, each text once, in the order of the file."""
    tokens = tokens_of(source)
    partner = match_brackets(tokens)
    found = {}
    for maker in (
        operators(tokens), constants(tokens), conditions(source, tokens, partner),
        statements(source, tokens, partner), indices(source, tokens, partner), arguments(source, tokens, partner),
    ):
        for mutant in maker:
            found.setdefault(mutant.apply(source), mutant)
    return sorted(found.values(), key=lambda m: (m.start, m.end, m.text))
