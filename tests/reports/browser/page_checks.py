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
  if (document.documentElement.scrollWidth > width) found.push(`the page is ${document.documentElement.scrollWidth} wide`);
  return found;
})()"""


def check_everywhere(test, page, path):
    """Opens the page at all widths, light and dark, and in print: `test` is a unittest.TestCase."""
    for scheme in ("light", "dark"):
        for width in WIDTHS:
            with test.subTest(page=path, width=width, scheme=scheme):
                page.media("screen", scheme)
                page.resize(width)
                page.open(path)
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
