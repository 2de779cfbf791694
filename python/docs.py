# SPDX-License-Identifier: MIT
"""docs.py STUB: what help() tells, as rows of C++, from the names, signatures and texts of a stub file."""

import ast
import sys


def literal(text):
    quoted = text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n")
    return f'"{quoted}"'


def signature(function, is_method):
    """The arguments without types, as inspect.signature takes them from a documentation."""
    arguments = function.args
    for argument in (*arguments.posonlyargs, *arguments.args, *arguments.kwonlyargs, arguments.kwarg):
        if argument:
            argument.annotation = None
    if is_method and arguments.args:
        arguments.args[0].arg = "$" + arguments.args[0].arg
    name = "" if function.name == "__init__" else function.name
    return f"{name}({ast.unparse(arguments)})\n--\n\n"


def rows(body, scope=""):
    for node in body:
        if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
            text = ast.get_docstring(node) or ""
            for inner in node.body:
                if isinstance(inner, ast.FunctionDef) and inner.name == "__init__":
                    text = node.name + signature(inner, True) + text
            yield node.name, text
            yield from rows(node.body, node.name + ".")
        elif isinstance(node, ast.FunctionDef) and node.name != "__init__":
            marks = [ast.unparse(mark) for mark in node.decorator_list]
            if any(mark.endswith(".setter") for mark in marks):
                continue
            text = ast.get_docstring(node) or ""
            if "property" not in marks:
                text = signature(node, bool(scope) and "staticmethod" not in marks) + text
            yield scope + node.name, text


with open(sys.argv[1]) as file:
    for name, text in rows(ast.parse(file.read()).body):
        print("{%s, %s}," % (literal(name), literal(text)))
