"""Random numbers that are the same on every platform and with every version of Python: SplitMix64."""

MASK = (1 << 64) - 1


class Random:
    def __init__(self, seed):
        self.state = seed & MASK

    def word(self):
        self.state = (self.state + 0x9E3779B97F4A7C15) & MASK
        x = self.state
        x = ((x ^ (x >> 30)) * 0xBF58476D1CE4E5B9) & MASK
        x = ((x ^ (x >> 27)) * 0x94D049BB133111EB) & MASK
        return x ^ (x >> 31)

    def below(self, limit):
        return self.word() % limit

    def between(self, low, high):
        """An integer from `low` to `high`, both included."""
        return low + self.below(high - low + 1)

    def chance(self, percent):
        return self.below(100) < percent

    def choice(self, items):
        return items[self.below(len(items))]

    def weighted(self, pairs):
        """One value of (weight, value) pairs."""
        at = self.below(sum(weight for weight, _ in pairs))
        for weight, value in pairs:
            if at < weight:
                return value
            at -= weight
        raise AssertionError("weights changed")

    def shuffled(self, items):
        left = list(items)
        return [left.pop(self.below(len(left))) for _ in items]
