"""Test case reduction: removes declarations and statements and simplifies expressions, as long as the program still fails."""
import re

from model import Items, Node, literal

WORD = re.compile(r"\w+")
TEST = re.compile(r'test "')
DECLARED = re.compile(r"\s*(?:@\w+\s+)?(?:fn|kernel|structure|struct|enum|translator) (\w+)")


class Shrinker:
    """Shrinks `program`. `is_interesting` says whether a text still has the failure; `program` is always the smallest one
    found so far that has it."""

    def __init__(self, program, is_interesting, most_asked=400):
        self.program, self.is_interesting, self.left = program, is_interesting, most_asked

    def run(self, title=""):
        """Shrinks. `title` is that of the failing test, if known."""
        if title:
            self.keep_test(title)
        before = None
        while before != self.program.text() and self.left > 0:
            before = self.program.text()
            self.drop_unused()
            self.remove_items(self.program.items)
            self.simplify(self.program.items)

    def keep_test(self, title):
        """Removes all tests but the one with this title, if the failure stays."""
        items = self.program.items
        before = items.parts
        items.parts = [item for item in before if not TEST.match(item.text()) or item.text().startswith(f'test "{title}"')]
        if not self.holds():
            items.parts = before
        self.drop_unused()

    def drop_unused(self):
        """Removes all unused declarations at once, if the failure stays."""
        items = self.program.items
        before, changed = list(items.parts), True
        while changed:
            texts = [item.text() for item in items.parts]
            words = [set(WORD.findall(text)) for text in texts]
            names = [DECLARED.match(text) for text in texts]
            kept = [item for i, item in enumerate(items.parts)
                    if not names[i] or any(names[i][1] in words[k] for k in range(len(texts)) if k != i)]
            changed, items.parts = len(kept) < len(items.parts), kept
        if len(items.parts) < len(before) and not self.holds():
            items.parts = before

    def holds(self):
        self.left -= 1
        return self.left >= 0 and self.is_interesting(self.program.text())

    def remove_items(self, node):
        if isinstance(node, Items):
            self.remove_from(node)
        for child in node.children():
            self.remove_items(child)

    def remove_from(self, items):
        """Removes all items, else halves, quarters and so on, each time from the end, since later items use earlier ones."""
        size = len(items.parts)
        while size > 0:
            end = len(items.parts)
            while end > 0:
                start = max(0, end - size)
                removed = items.parts[start:end]
                del items.parts[start:end]
                if not self.holds():
                    items.parts[start:start] = removed
                end = start
            size //= 2

    def simplify(self, node):
        for i, part in enumerate(node.parts):
            if isinstance(part, str):
                continue
            if part.type is not None:
                part = self.simplest(node, i)
            elif isinstance(node, Items) and self.unwrap(node, i):
                continue  # the statements of the body stand here now; the next round simplifies the first of them
            self.simplify(node.parts[i])

    def simplest(self, node, i):
        """Replaces an expression by a literal, or by one of its subexpressions of the same type."""
        part = node.parts[i]
        candidates = [Node(literal(part.type), type=part.type)] + inner_of_type(part, part.type)
        for candidate in sorted(candidates, key=lambda c: len(c.text())):
            if len(candidate.text()) >= len(part.text()):
                break
            node.parts[i] = candidate
            if self.holds():
                return candidate
        node.parts[i] = part
        return part

    def unwrap(self, items, i):
        """Replaces a loop or a branch by its body."""
        statement = items.parts[i]
        for body in [child for child in statement.children() if isinstance(child, Items)]:
            items.parts[i:i + 1] = body.parts
            if self.holds():
                return True
            items.parts[i:i + len(body.parts)] = [statement]
        return False


def inner_of_type(node, wanted):
    found = []
    for child in node.children():
        if child.type == wanted:
            found.append(child)
        found += inner_of_type(child, wanted)
    return found
