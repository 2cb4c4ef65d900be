"""Words of contacts: the order in which the gaps a, b, c of four rods on a line close.

A contact takes gaps and their rates through the same linear map
(docs/decisions/0019-certificates.md), so that a word repeats along eigenvectors of its round map.
Source: Dolmaire & Huebner-Rosenau, arXiv 2411.10324 (2024).
"""

from fractions import Fraction

import numpy as np

LONGEST = 60  # period looked for
REPEATED = 120  # contacts that must repeat, and five periods: (ab)^5 alone is no word ab


def contact(gap, rates, restitution):
    """Gaps or rates after a contact at one gap; list (3).

    Gap j and its neighbours: (C u)_j = -e u_j, (C u)_i = u_i + (1 + e) u_j / 2.
    """
    after = [each + (1 + restitution) / 2 * rates[gap] if abs(k - gap) == 1 else each
             for k, each in enumerate(rates)]
    after[gap] = -restitution * rates[gap]
    return after


def before_contact(gap, rates, restitution):
    """The inverse of `contact`."""
    closing = -rates[gap] / restitution
    before = [each - (1 + restitution) / 2 * closing if abs(k - gap) == 1 else each
              for k, each in enumerate(rates)]
    before[gap] = closing
    return before


def places(word):
    """The gaps of a word as numbers: "abcb" is [0, 1, 2, 1]."""
    return [ord(letter) - ord("a") for letter in word]


def canonical(order):
    """The alphabetically first among the rotations of a period and of its mirror image, as text."""
    turned = [each[k:] + each[:k] for each in (order, [2 - gap for gap in order])
              for k in range(len(order))]
    return "".join(chr(ord("a") + gap) for gap in min(turned))


def eventual_word(order):
    """The word that the contacts have come to repeat, or nothing if none with LONGEST letters.

    order: list of int, the gaps in the order of their contacts
    """
    for period in range(1, LONGEST + 1):
        tail = order[-max(REPEATED, 5 * period) - period:]
        if len(tail) >= 6 * period and tail[period:] == tail[:-period]:
            return canonical(order[-period:])
    return None


def scaled_contacts(gaps, rates, restitution, contacts):
    """The order of contacts without the program: in double, scaled after each contact.

    On a line gaps and rates are all there is, and scaling them costs no digits. It stops where two
    rods have nearly come to rest beside the others.
    """
    order, gaps, rates = [], list(gaps), list(rates)
    while len(order) < contacts:
        if min(max(map(abs, rates[:2])), max(map(abs, rates[1:]))) < 1e-250:
            break
        flights = {k: -gaps[k] / rates[k] for k in range(3)
                   if rates[k] < 0 and order[-1:] != [k]}
        if not flights:
            break
        first = min(flights, key=flights.get)
        gaps = [gap + rate * flights[first] for gap, rate in zip(gaps, rates)]
        gaps[first] = 0.0
        rates = contact(first, rates, restitution)
        widest, fastest = max(gaps), max(map(abs, rates))
        gaps, rates = [gap / widest for gap in gaps], [rate / fastest for rate in rates]
        order.append(first)
    return order


def exact_contacts(gaps, rates, restitution, contacts):
    """The order of contacts in fractions, of the numbers given (Decimal), without rounding."""
    order, restitution = [], Fraction(restitution)
    offsets, rates = [[Fraction(each) for each in vector] for vector in (gaps, rates)]
    while len(order) < contacts:
        times = {k: -offsets[k] / rates[k] for k in range(3)
                 if rates[k] < 0 and order[-1:] != [k]}
        if not times:
            break
        first = min(times, key=times.get)
        offsets, rates = (contact(first, each, restitution) for each in (offsets, rates))
        order.append(first)
    return order


def name(word):
    """(ab)^3(cb)^3 in place of the alphabetically first rotation abababcbcbcb."""
    half = len(word) // 4
    family = "ab" * half + "cb" * half
    return f"(ab)^{half}(cb)^{half}" if word == family and half > 1 else word


def in_order(word, offsets, rates, restitution):
    """Whether gaps `offsets + rates t` close in the order of the word, all at times t < 0."""
    last = -np.inf
    for gap in places(word) * 2:
        time = -offsets[gap] / rates[gap]
        others = [offsets[k] + rates[k] * time for k in range(3) if k != gap]
        if rates[gap] >= 0 or not last < time < 0 or min(others) <= 0:
            return False
        last = time
        rates, offsets = contact(gap, rates, restitution), contact(gap, offsets, restitution)
    return True


def common_length(one, other):
    """Number of leading contacts that two orders have in common."""
    apart = [k for k, (left, right) in enumerate(zip(one, other)) if left != right]
    return min(apart, default=min(len(one), len(other)))


def rounds_held(order, word):
    """Number of leading contacts that follow the word, in rounds."""
    return common_length(order, places(word) * (len(order) // len(word) + 1)) / len(word)
