"""What tests of pages have in common: moving their controls, reading their plots, and what every page must do."""

import os

from browser import Browser, find_browser
from checks import check


def set_control(page, view, name, value):
    """Moves a slider, or chooses; waits for the drawing."""
    page.run(f"""(async () => {{
      const control = document.querySelector('#{view} [name="{name}"]');
      if (control.type === 'checkbox') control.checked = {str(value).lower()}; else control.value = {value!r};
      await (control.oninput ?? control.onchange)();
      await new Promise(done => setTimeout(done, 100));
    }})()""")


def plot(page, view, expression):
    return page.run(f"(() => {{ const plot = document.querySelector('#{view} .plot'); return {expression}; }})()")


def close(value, wanted):
    return value is not None and abs(value - wanted) <= 1e-5 * abs(wanted)


def check_page(path, views, work):
    size = os.path.getsize(path) / 1e6
    name = os.path.basename(path)
    check(size < 5, f"{name} has {size:.1f} MB, below 5")
    for width in (1400, 800):
        page = Browser(find_browser(), width)
        try:
            ready = page.open(path)
            check(ready, f"{name} is drawn at {width} pixels")
            if ready:
                drawn = page.run("[...document.querySelectorAll('.view')].filter(v => v.querySelector('.main-svg'))"
                                 ".map(v => v.id).join(' ')")
                check(drawn == " ".join(views), f"its views: {drawn}")
                check(page.run("document.documentElement.scrollWidth <= window.innerWidth"),
                      f"nothing is wider than {width} pixels")
                if width == 1400:
                    work(page)
                    shown = page.run("[...document.images].filter(i => i.offsetParent !== null).length")
                    page.send("Emulation.setEmulatedMedia", media="print")
                    printed = page.run("[...document.images].filter(i => i.offsetParent !== null).length")
                    check(printed > shown and page.run("document.images.length") == printed,
                          f"print shows all {printed} pictures, the screen {shown} beside the views")
                    check(len(page.print_pdf()) > 50000, "the page prints")
            check(page.complaints == [], f"the console is silent {page.complaints[:3]}")
        finally:
            page.close()
