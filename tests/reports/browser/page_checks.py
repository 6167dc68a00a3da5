"""What holds of every page of ours, at every width and in print."""

WIDTHS = (360, 800, 1400)
PRINT_WIDTH = 718  # A4 with margins of 1 cm, in CSS pixels

# Elements that end to the right of the page or begin to its left, but for what scrolls in a box of its own, and for the
# shapes inside a picture, which the picture cuts off itself.
OUTSIDE = """(() => {
  const width = document.documentElement.clientWidth;
  const scrolls = (element) => {
    for (let up = element.parentElement; up && up !== document.body; up = up.parentElement) {
      if (['auto', 'scroll'].includes(getComputedStyle(up).overflowX)) return true;
    }
    return false;
  };
  const found = [];
  for (const element of document.body.querySelectorAll('*')) {
    if (element.ownerSVGElement) continue;
    const r = element.getBoundingClientRect();
    if (r.width === 0 || r.height === 0 || (r.left >= -0.5 && r.right <= width + 0.5) || scrolls(element)) continue;
    found.push(`${element.tagName.toLowerCase()}.${element.className} from ${r.left} to ${r.right} of ${width}`);
  }
  const whole = document.documentElement.scrollWidth;
  if (whole > width) found.push(`the page is ${whole} wide`);
  return found;
})()"""

OPEN_DETAILS = "document.querySelectorAll('details').forEach((details) => { details.open = true; })"


def check_everywhere(test, page, path):
    """Opens the page at all widths, light and dark, as it is and with everything closed opened; then in print, opened.
    `test` is a unittest.TestCase."""
    for scheme in ("light", "dark"):
        for width in WIDTHS:
            with test.subTest(page=path, width=width, scheme=scheme):
                page.media("screen", scheme)
                page.resize(width)
                page.open(path)
                check_opened(test, page)
                page.evaluate(OPEN_DETAILS)
                page.settle()
                check_opened(test, page)
    with test.subTest(page=path, media="print"):
        page.media("print")
        page.resize(PRINT_WIDTH)
        page.settle()
        check_opened(test, page)
        test.assertGreater(len(page.call("Page.printToPDF")["data"]), 1000)
        page.media("screen")


def check_opened(test, page):
    test.assertEqual(page.evaluate(OUTSIDE), [])
    test.assertEqual(page.problems(), [])
    test.assertEqual(page.requests(), [])


# What a reader of the page's structure misses: one h1, no level left out, a name for each picture, heads for tables.
STRUCTURE = """(() => {
  const found = [];
  if (!document.documentElement.lang) found.push('no language');
  if (!document.title) found.push('no title');
  const levels = [...document.querySelectorAll('h1, h2, h3, h4, h5, h6')].map((h) => Number(h.tagName[1]));
  if (levels[0] !== 1 || levels.filter((level) => level === 1).length !== 1) found.push(`headings ${levels}`);
  levels.forEach((level, i) => {
    if (i > 0 && level > levels[i - 1] + 1) found.push(`h${level} after h${levels[i - 1]}`);
  });
  for (const svg of document.querySelectorAll('svg')) {
    const named = svg.getAttribute('aria-label') || svg.querySelector('title')?.textContent;
    if (!named && svg.getAttribute('aria-hidden') !== 'true') found.push('a picture without a name');
  }
  for (const image of document.querySelectorAll('img')) if (!image.alt) found.push('an image without words');
  for (const table of document.querySelectorAll('table')) {
    if (!table.querySelector('th')) found.push('a table without heads');
  }
  const ids = [...document.querySelectorAll('[id]')].map((element) => element.id);
  for (const id of ids) if (ids.indexOf(id) !== ids.lastIndexOf(id)) found.push(`two elements are called ${id}`);
  for (const link of document.querySelectorAll('a[href^="#"]')) {
    if (!document.getElementById(decodeURIComponent(link.hash.slice(1)))) found.push(`nothing behind ${link.hash}`);
  }
  return found;
})()"""


def check_structure(test, page):
    test.assertEqual(page.evaluate(STRUCTURE), [])
