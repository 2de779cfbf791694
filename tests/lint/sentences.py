#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Finds the sentences of all documents and of all C++ comments, and judges their length.

--longest N   fails, and names every sentence of more than N words
--riddles     fails, and names every sentence that begins with "What" or "Of" and asks nothing
--sample N    prints N sentences drawn at random; --seed chooses others
--self-test   checks the extraction on texts whose sentences are known

Code in backticks, a link's address and a formula with spaces (a = b + c) count as one word or as none.
Code blocks, headings and pictures hold no sentences; a table's cell is one only if it ends with a full stop.
"""

import argparse
import collections
import pathlib
import random
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
DOCUMENTS = ("README.md", "CHANGELOG.md", "CONTRIBUTING.md", "SECURITY.md", "packaging/README.md",
             "docs/**/*.md", "docs/*.7")
CODE_FOLDERS = ("lib", "apps", "plugins", "compare", "python", "tests")
RIDDLES_REMAIN = ("tests/",)  # files and folders, by how their paths begin, whose sentences may still begin with a riddle

Sentence = collections.namedtuple("Sentence", "line text words")

LIST_ITEM = re.compile(r"\s*(?:[-*+]|\d+[.)])\s+")
LABEL = re.compile(r"\s*[A-Z][a-z]+:\s")  # Shape, Units, Expects and so on begin a sentence
RIDDLE = re.compile(r"(?:[A-Z][a-z]+:\s+)?(?:[Ww]hat|[Oo]f)\b(?![^?]*\?\W*$)")  # the subject comes too late
ONE_WORD = (
    re.compile(r"``.+?``|`[^`]+`", re.S),     # code
    re.compile(r"\$[^$\n]+\$"),               # a formula in TeX
    re.compile(r"\]\([^)]*\)"),               # the address of a link
    re.compile(r"(?<=\S)\s+(?:[-+*/=<>~^|]|[<>=!:]=|->)\s+(?=\S)"),  # an operator glues its operands
)
PICTURE = re.compile(r"!\[[^\]]*\]\([^)]*\)")
END = re.compile(r"""(?<=\S)[.!?]+["')\]*_]*(?=\s|$)""")
ABBREVIATION = re.compile(r"(?:^|[\s(])(?:e\.g|i\.e|vs|cf|approx|pp|resp)$")
CPP_TOKEN = re.compile(
    r'R"(?P<mark>[^(\s]*)\(.*?\)(?P=mark)"'
    r"""|"(?:\\.|[^"\\\n])*"|(?<![0-9A-Fa-f])'(?:\\.|[^'\\\n])+'"""
    r"|(?P<line>//[^\n]*)|(?P<block>/\*.*?\*/)", re.S)


def split(block):
    """The sentences of a block: a list of (line number, text) that belong together."""
    text = "\n".join(line for _, line in block)
    masked = PICTURE.sub(lambda found: " " * len(found[0]), text)
    for pattern in ONE_WORD:
        masked = pattern.sub(lambda found: "x" * len(found[0]), masked)
    begins = 0
    ends = [found.end() for found in END.finditer(masked) if ends_a_sentence(masked, found)]
    for end in ends + [len(text)]:
        words = sum(any(c.isalnum() for c in word) for word in masked[begins:end].split())
        if words:
            first = begins + len(masked[begins:]) - len(masked[begins:].lstrip())
            line = block[text.count("\n", 0, first)][0]
            yield Sentence(line, " ".join(text[begins:end].split()), words)
        begins = end


def ends_a_sentence(text, found):
    if ABBREVIATION.search(text[:found.start()]):
        return False
    after = text[found.end():].lstrip()[:1]
    return not (after.islower() and not found[0].startswith(".") or after.islower() and ".." in found[0])


class Blocks:
    """Collects lines into blocks whose sentences may run over lines."""

    def __init__(self):
        self.done = []
        self.open = []

    def add(self, number, text):
        self.open.append((number, text))

    def close(self):
        if self.open:
            self.done.append(self.open)
        self.open = []

    def add_prose(self, number, text):
        """A line of text that begins a block if it is an item of a list or a label."""
        item = LIST_ITEM.match(text)
        if item or LABEL.match(text):
            self.close()
        self.add(number, text[item.end():] if item else text)

    def sentences(self):
        self.close()
        return [sentence for block in self.done for sentence in split(block)]


def markdown(text):
    blocks = Blocks()
    fence = None
    for number, line in enumerate(text.splitlines(), 1):
        mark = re.match(r"\s*(```|~~~|\$\$)", line)
        if fence or mark:
            blocks.close()
            if fence and mark and mark[1] == fence:
                fence = None
            elif mark and not fence and line.count(mark[1]) == 1:
                fence = mark[1]
        elif re.match(r"\s*\|", line):
            blocks.close()
            for cell in re.split(r"(?<!\\)\|", line):
                if re.search(r"[.!?][)*_]*\s*$", cell):
                    blocks.add(number, cell)
                    blocks.close()
        elif not line.strip() or re.match(r"#|\s*<!--|\s*[-=]{3,}\s*$", line):
            blocks.close()
        elif blocks.open or not line.startswith("    "):
            blocks.add_prose(number, re.sub(r"^\s*>\s?", "", line))
    return blocks.sentences()


def manual_page(text):
    blocks = Blocks()
    for number, line in enumerate(text.splitlines(), 1):
        macro = re.match(r"\.([A-Z][a-z])\b\s*(.*)", line)
        if not macro:
            blocks.add(number, line)
        elif macro[1] in ("Xr", "Nm", "Fl", "Li", "Pa", "Ic", "Ev", "Ar", "Em", "Cm", "Ql"):
            stop = re.search(r"\s([.,;:)]+)$", macro[2])
            blocks.add(number, "`" + macro[1] + "`" + (stop[1] if stop else ""))
        else:
            blocks.close()
    return blocks.sentences()


def cpp(text):
    blocks = Blocks()
    last = None  # line, column, marker and whether code stands before it
    for token in CPP_TOKEN.finditer(text):
        comment = token["line"] or token["block"]
        if not comment:
            continue
        start = token.start()
        number = text.count("\n", 0, start) + 1
        column = start - (text.rfind("\n", 0, start) + 1)
        trails = bool(text[start - column:start].strip())
        if token["block"]:
            blocks.close()
            for offset, line in enumerate(comment[2:-2].splitlines()):
                blocks.add_prose(number + offset, re.sub(r"^\s*\*\s?", "", line))
            blocks.close()
            last = None
            continue
        marker = re.match(r"///?[<!]?", comment)[0]
        here = (number, column, marker)
        if trails or last is None or here != (last[0] + 1, *last[1:]):
            blocks.close()
        last = here
        said = comment[len(marker):]
        if not said.strip() or re.match(r"\s*(SPDX-|NOLINT|namespace \S+$|clang-format|[-=]{3})", said):
            blocks.close()
        elif said.startswith("     ") and not LABEL.match(last_label(blocks)):
            blocks.close()  # a formula or a piece of code
        else:
            blocks.add_prose(number, said)
    return blocks.sentences()


def last_label(blocks):
    """What the open block begins with: lines that continue a label's text are indented."""
    return blocks.open[0][1] if blocks.open else ""


def reader(path):
    return {".md": markdown, ".7": manual_page}.get(path.suffix, cpp)


def files():
    for pattern in DOCUMENTS:
        yield from sorted(ROOT.glob(pattern))
    for folder in CODE_FOLDERS:
        yield from sorted(path for path in (ROOT / folder).rglob("*") if path.suffix in (".h", ".cpp"))


def all_sentences():
    for path in files():
        for sentence in reader(path)(path.read_text()):
            yield path.relative_to(ROOT), sentence


KNOWN = (  # reader, text, the words of each sentence
    (markdown, "One two. Three four five!\nSix", [2, 3, 1]),
    (markdown, "A name.of.this and 0.5 px, e.g. this. `make run all` ends\nhere.", [7, 3]),
    (markdown, "# No sentence\n\nOne:\n\n    no sentence here.\n\n* two three\n  four\n* five", [1, 3, 1]),
    (markdown, "```\nNo sentence.\n```\nYes.", [1]),
    (markdown, "| no sentence | This is one. |\n|---|---|\n| 1.5 | 2 |", [3]),
    (markdown, "![no sentence](a.png)\n\nSee [the page](http://a.b/c d).\nNext.", [3, 1]),
    (markdown, "Here a = b + c, and N . (e - p) > 0 holds. Why? Since it does.", [6, 1, 3]),
    (markdown, "**Bold one.** (In brackets.) Two", [2, 2, 1]),
    (manual_page, ".Sh NAME\nOne\n.Nm l3d\ntwo,\n.Xr X 7 .\nThree.\n.Pp\nFour", [4, 1, 1]),
    (cpp, "/// One two\n/// three. Four\nint a; ///< five six\nint b; // seven\n// eight\n", [3, 1, 2, 1, 1]),
    (cpp, "int a; ///< one two\n       ///< three\n", [3]),
    (cpp, "/// One.\n/// Units:   two,\n///          three.\n/// Cost:  four\n///\n/// Five", [1, 3, 2, 1]),
    (cpp, "// One:\n//     no = sentence;\n// two\n\n// three\n", [1, 1, 1]),
    (cpp, "auto a = \"http://no\"; char b = '\"'; // one\nint c = 1'000; // two\n", [1, 1]),
    (cpp, "// SPDX-License-Identifier: MIT\n// One\n/* two\n * three */ int a;\n", [1, 2]),
)


KNOWN_RIDDLES = {
    "What the eye sees.": True, "of a row": True, "Lives: of one worker.": True, "Of two, the first stays.": True,
    "What is it?": False, "(What is it?)": False, "Offsets of rows.": False, "The words of what is seen.": False,
    "Whatever it is, it stays.": False,
}


def self_test():
    wrong = 0
    for text, expected in KNOWN_RIDDLES.items():
        if bool(RIDDLE.match(text)) != expected:
            print(f"not ok riddle: {text!r}")
            wrong += 1
    for read, text, expected in KNOWN:
        found = [sentence.words for sentence in read(text)]
        if found != expected:
            print(f"not ok {read.__name__}: {found} instead of {expected} words in {text!r}")
            wrong += 1
    return wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--longest", type=int, metavar="N")
    parser.add_argument("--riddles", action="store_true")
    parser.add_argument("--sample", type=int, metavar="N")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--self-test", action="store_true")
    options = parser.parse_args()
    failed = self_test() if options.self_test else 0
    if options.longest:
        for path, sentence in all_sentences():
            if sentence.words > options.longest:
                print(f"{path}:{sentence.line}: {sentence.words} words: {sentence.text}")
                failed += 1
    if options.riddles:
        for path, sentence in all_sentences():
            if RIDDLE.match(sentence.text) and not str(path).startswith(RIDDLES_REMAIN):
                print(f"{path}:{sentence.line}: begins with its riddle, not with its subject: {sentence.text}")
                failed += 1
    if options.sample:
        found = list(all_sentences())
        for path, sentence in random.Random(options.seed).sample(found, min(options.sample, len(found))):
            print(f"{path}:{sentence.line}: {sentence.text}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
