"""Finds small changes of a C++ source, and writes the source with one of them made or with all of them switchable.

There is no parser here, only tokens and the habits of clang-format: a comparison has spaces round it, the bracket of a
template has none. What does not compile is found out by compiling.
"""
import dataclasses
import re

TOKEN = re.compile(
    r"""(?P<skip>//[^\n]*|/\*.*?\*/|^[ \t]*\#[^\n]*(?:\\\n[^\n]*)*|R"(?P<mark>[^(\s]*)\(.*?\)(?P=mark)"|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])+')"""
    r"""|(?P<number>(?:\d[\d']*\.?[\d']*|\.\d+)(?:[eE][+-]?\d+)?[uUlLfF]*|0[xX][0-9a-fA-F]+[uUlL]*)"""
    r"""|(?P<word>[A-Za-z_]\w*)"""
    r"""|(?P<sign><<=|>>=|<=>|\.\.\.|->|::|<<|>>|<=|>=|==|!=|&&|\|\||\+\+|--|[-+*/%&|^]=|[^\s\w])""",
    re.S | re.M | re.X)
# Lines that say something to people, or that change nothing but time and memory.
TALK = re.compile(r"\breserve\(|\bassert\(|\bstatic_assert\b|\b[Pp]rogress|\bfmt::|\bError\b|\bwarn\w*\(|\bcase\b|\benum\b|\bfailed?\(")
KEYWORDS = set("return if else for while do switch case default break continue using namespace const constexpr auto static "
               "struct class enum template typename public private throw goto delete new inline int double bool".split())
# operator -> what it may become
COMPARISONS = {"<": [">=", "<="], ">": ["<=", ">="], "<=": [">", "<"], ">=": ["<", ">"], "==": ["!="], "!=": ["=="]}
ARITHMETIC = {"+": ["-"], "-": ["+"], "*": ["/"], "/": ["*"]}
NAMES = {"<": "Less", ">": "Greater", "<=": "AtMost", ">=": "AtLeast", "==": "Equal", "!=": "Unequal",
         "+": "Plus", "-": "Minus", "*": "Times", "/": "Over"}
SPACE = "::sinew_mutation::"


@dataclasses.dataclass
class Token:
    kind: str
    text: str
    begin: int
    end: int


@dataclasses.dataclass
class Change:
    """The text from begin to end becomes `now`; `switched` is the same with both in it, @ for its number, or None if a
    span is kept between `before` and `after`."""
    line: int
    begin: int
    end: int
    now: str
    says: str
    switched: str | None = None
    operator: str | None = None  # what it was, if it is one: several changes of one operator go together
    before: str = ""
    after: str = ""


def tokens_of(text):
    found = [Token(m.lastgroup if m.lastgroup != "mark" else "skip", m.group(), m.start(), m.end()) for m in TOKEN.finditer(text)]
    return [t for t in found if t.kind != "skip"]


def closing(tokens, at):
    """Index of the bracket that closes the one at `at`."""
    depth = 0
    for i in range(at, len(tokens)):
        depth += tokens[i].text in "([{" and tokens[i].kind == "sign"
        depth -= tokens[i].text in ")]}" and tokens[i].kind == "sign"
        if depth == 0:
            return i
    return len(tokens) - 1


def operand(tokens, at, step):
    """Index of the last token of what stands on one side of an && or ||; None if it holds what may not be wrapped."""
    depth, i = 0, at + step
    opens, closes = ("([{", ")]}") if step > 0 else (")]}", "([{")
    ends = {"&&", "||", "?", ":", ";", ",", "=", "return", "{", "}"}
    while 0 <= i < len(tokens):
        text = tokens[i].text
        if depth == 0 and (text in ends or (text in closes and tokens[i].kind == "sign")):
            return i - step
        depth += tokens[i].kind == "sign" and text in opens
        depth -= tokens[i].kind == "sign" and text in closes
        i += step
    return None


def other_number(text):
    """Another value, well away; None where there is none to choose."""
    digits = text.rstrip("uUlLfF").replace("'", "")
    suffix = text[len(text.rstrip("uUlLfF")):] if not text.lower().startswith("0x") else ""
    if text.lower().startswith("0x"):
        return None
    if re.fullmatch(r"\d+", digits):
        return f"{int(digits) + 1}{suffix}"
    value = float(digits)
    changed = 1.0 if value == 0 else value * 1000 if value < 1e-4 else value * 1.5
    text = f"{changed:.12g}"
    return (text if re.search(r"[.e]", text) else text + ".0") + suffix


class Finder:
    def __init__(self, text):
        self.text = text
        self.tokens = tokens_of(text)
        self.lines = text.split("\n")
        self.found = []
        self.in_for = self.heads_of_for()

    def heads_of_for(self):
        """The tokens between the brackets of all `for`."""
        inside = set()
        for i, token in enumerate(self.tokens[:-1]):
            if token.text == "for":
                inside.update(range(i + 2, closing(self.tokens, i + 1)))
        return inside

    def line_of(self, begin):
        return self.text.count("\n", 0, begin) + 1

    def add(self, first, last, now, says, **more):
        line = self.line_of(first.begin)
        if not TALK.search(self.lines[line - 1]):
            self.found.append(Change(line, first.begin, last.end, now, says, **more))

    def source(self, first, last):
        return self.text[first.begin:last.end]

    def run(self):
        for i, token in enumerate(self.tokens):
            before = self.tokens[i - 1] if i else Token("sign", ";", 0, 0)
            after = self.tokens[i + 1] if i + 1 < len(self.tokens) else Token("sign", ";", 0, 0)
            if token.kind == "number":
                self.number(token, before, after)
            elif token.text in ("&&", "||"):
                self.part_of_condition(i)
            elif token.text in NAMES and self.text[token.begin - 1:token.begin] in (" ", "\n") and \
                    self.text[token.end:token.end + 1] in (" ", "\n"):
                self.operator(token, before)
            elif token.text == "-" and (before.text in ("(", ",", "=", "return", "?", ":", "{", "*") or before.text in NAMES) and \
                    after.kind != "number":
                self.add(token, token, "", "- dropped", switched=SPACE + "Negative{@} * ")
            elif token.text in ("min", "max") and after.text == "(" and before.text == "::":
                self.extreme(i, token)
            elif token.text == "if" and after.text == "(":
                self.condition(i)
            elif before.text in (";", "{", "}", ")", "else"):
                self.statement(i)
        return self.found

    def number(self, token, before, after):
        now = other_number(token.text)
        in_template = self.text[token.end] == ">" or before.text == "<" and after.text == ","
        if now is None or in_template or before.text == "case":
            return
        self.add(token, token, now, f"{token.text} -> {now}", switched=f"{SPACE}pick(@, {token.text}, {now})")

    def operator(self, token, before):
        if before.text in ("operator", "(", ",", "return", "="):
            return
        for now in {**COMPARISONS, **ARITHMETIC}[token.text]:
            self.add(token, token, now, f"{token.text} -> {now}", operator=token.text)

    def extreme(self, i, token):
        first = self.tokens[i - 2]
        if first.text == "std":
            other = "max" if token.text == "min" else "min"
            self.add(first, token, f"std::{other}", f"{token.text} -> {other}",
                     switched=f"{SPACE}Extreme<{'true' if token.text == 'min' else 'false'}>{{@}}")

    def part_of_condition(self, i):
        sign, neutral = self.tokens[i].text, "true" if self.tokens[i].text == "&&" else "false"
        for step in (1, -1):
            end = operand(self.tokens, i, step)
            if end is None or end == i:
                continue
            first, last = (self.tokens[i + 1], self.tokens[end]) if step > 0 else (self.tokens[end], self.tokens[i - 1])
            is_reference = self.text[self.tokens[i].begin - 1] not in " \n"  # auto&&
            if is_reference or "{" in self.source(first, last):
                continue
            switch = f"({SPACE}on(@) || (" if sign == "&&" else f"(!{SPACE}on(@) && ("
            self.add(first, last, neutral, f"{sign} {shown(self.source(first, last))} dropped", before=switch, after="))")

    def condition(self, i):
        end = closing(self.tokens, i + 1)
        inside = self.tokens[i + 2:end]
        depth = 0
        for t in inside:
            depth += t.text in ("(", "{", "[")
            depth -= t.text in (")", "}", "]")
            if depth == 0 and t.text in (";", "=", "const", "auto"):
                return  # declares something
        text = self.source(inside[0], inside[-1])
        self.add(inside[0], inside[-1], "false", f"if ({shown(text)}) never", before=f"!{SPACE}on(@) && (", after=")")

    def statement(self, i):
        """An assignment or a call that stands alone."""
        tokens, j = self.tokens, i
        if tokens[i].kind != "word" or tokens[i].text in KEYWORDS or i in self.in_for or (i and tokens[i - 1].text == ")" and not self.heads(i - 1)):
            return
        while j < len(tokens):
            j += 1
            if tokens[j].text in ("(", "["):
                j = closing(tokens, j) + 1
            while tokens[j].text in ("(", "["):
                j = closing(tokens, j) + 1
            if tokens[j].text not in (".", "->", "::"):
                break
            j += 1
        assigns = tokens[j].text == "=" or tokens[j].text in ("+=", "-=", "*=", "/=", "|=", "&=")
        calls = tokens[j].text in (";", ",") and tokens[j - 1].text == ")"
        if not (assigns or calls):
            return
        depth = 0
        while tokens[j].text != ";" or depth:
            depth += tokens[j].text in ("(", "{", "[")
            depth -= tokens[j].text in (")", "}", "]")
            if depth < 0 or j + 1 == len(tokens):
                return
            j += 1
        text = self.source(tokens[i], tokens[j])
        if not TALK.search(text):
            self.add(tokens[i], tokens[j], ";", f"{shown(text)} dropped", before=f"{{ if (!{SPACE}on(@)) ", after=" }")

    def heads(self, at):
        """Whether the bracket that ends at `at` is that of an if, a for or a while."""
        depth = 0
        for i in range(at, -1, -1):
            depth += self.tokens[i].text == ")"
            depth -= self.tokens[i].text == "("
            if depth == 0:
                return self.tokens[i - 1].text in ("if", "for", "while")
        return False


def shown(text):
    text = " ".join(text.split())
    return text if len(text) <= 60 else text[:57] + "..."


def changes_of(text):
    """All changes of a source, in its order."""
    return sorted(Finder(text).run(), key=lambda c: (c.begin, c.end, c.says))


def with_one(text, change):
    return text[:change.begin] + change.now + text[change.end:]


def with_switches(text, numbered):
    """The source with all changes in it, each on when its number is. numbered: pairs (number, change)."""
    opened, closed, replaced, operators = {}, {}, {}, {}
    for number, change in numbered:
        if change.operator:
            operators.setdefault(change.begin, []).append((number, change))
        elif change.switched is not None:
            replaced[change.begin] = (change.end, change.switched.replace("@", str(number)))
            continue
        opened.setdefault(change.begin, []).append((change.begin - change.end, change.before.replace("@", str(number))))
        closed.setdefault(change.end, []).append((change.end - change.begin, change.after))
    for begin, pairs in operators.items():
        sign = pairs[0][1].operator
        kinds = ", ".join(SPACE + NAMES[text] for text in (sign, *(change.now for _, change in pairs)))
        numbers = ", ".join(str(number) for number, _ in pairs)
        replaced[begin] = (pairs[0][1].end, f"{sign} {SPACE}Operator<{kinds}>{{{numbers}}} {sign}")
    out, at = ['#include "switch.h"\n#line 1\n'], 0
    while at <= len(text):
        out += [piece for _, piece in sorted(closed.get(at, []))]
        out += [piece for _, piece in sorted(opened.get(at, []))]
        if at in replaced:
            at, piece = replaced[at]
            out.append(piece)
        else:
            out.append(text[at:at + 1])
            at += 1
    return unfolded("".join(out))


def unfolded(text):
    """Constants whose value is switched are found when the program begins, not when it is compiled."""
    lines = text.split("\n")
    for i, line in enumerate(lines):
        if SPACE in line and "if constexpr" not in line:
            lines[i] = re.sub(r"\bconstexpr\b", "const", line)
    return "\n".join(lines)
