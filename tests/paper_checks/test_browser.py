"""The report in a real browser: pages load without a network, formulas and figures are drawn, links and search work."""

import shutil

import pytest
from selenium import webdriver
from selenium.webdriver.common.by import By
from selenium.webdriver.support.ui import Select

CHROMIUM, DRIVER = shutil.which("chromium"), shutil.which("chromedriver")
pytestmark = pytest.mark.skipif(
    not (CHROMIUM and DRIVER), reason="needs Debian's chromium and chromium-driver, which .ci/run installs where it can"
)
FLAGS = (
    "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-component-update",
    "--disable-background-networking", "--disable-sync", "--window-size=390,844",
)  # fmt: skip


@pytest.fixture(scope="module")
def browser(tmp_path_factory):
    options = webdriver.ChromeOptions()
    options.binary_location = CHROMIUM
    for flag in (*FLAGS, f"--user-data-dir={tmp_path_factory.mktemp('profile')}"):
        options.add_argument(flag)
    driver = webdriver.Chrome(options, webdriver.ChromeService(DRIVER))
    yield driver
    driver.quit()


def test_no_page_is_wider_than_its_window(browser, report):
    for page in sorted(report.glob("*.html")):
        browser.get(page.as_uri())
        assert browser.find_element(By.TAG_NAME, "h1").text
        for width in (390, 768, 1280, 1920):
            browser.set_window_size(width, 844)
            inner, needed = browser.execute_script("return [innerWidth, document.documentElement.scrollWidth]")
            assert abs(inner - width) < 20
            assert needed <= inner, f"{page.name} is wider than {width} by {needed - inner} pixels"


def test_formulas_and_figures_are_drawn(browser, report):
    browser.get((report / "smith2012.html").as_uri())
    heights = [f.size["height"] for f in browser.find_elements(By.CSS_SELECTOR, "article > .formula math")]
    assert len(heights) > 100
    assert min(heights) > 5
    fraction = browser.find_element(By.CSS_SELECTOR, "math mfrac").size["height"]
    assert fraction > 18  # two storeys: the browser lays MathML out, it does not print its text in a row
    figures = browser.find_elements(By.CSS_SELECTOR, "figure img")
    assert figures
    for figure in figures:
        browser.execute_script("arguments[0].scrollIntoView(); arguments[0].loading = 'eager'", figure)
        assert (
            browser.execute_async_script(
                "const [image, done] = arguments; image.decode().then(() => done(image.naturalWidth))", figure
            )
            > 100
        )


def test_the_fonts_of_the_formulas_are_on_the_page(browser, report):
    browser.get((report / "smith2012.html").as_uri())
    for family, letters in (("Report Math", "√∑"), ("Report Greek", "\U0001d700")):
        loaded = browser.execute_async_script(
            "const [f, text, done] = arguments; document.fonts.load('16px \"' + f + '\"', text)"
            ".then(found => done(found.map(face => face.status)))", family, letters,
        )  # fmt: skip
        assert loaded == ["loaded"], family


@pytest.mark.parametrize(
    ("query", "wanted"), [("62b", "smith2012:62b"), ("S_3", "smith2012:table1.S3"), ("(43)", "smith2012:43")]
)
@pytest.mark.parametrize("page", ["index", "lelas2024", "derivations"])
def test_a_statement_is_found_from_every_page(browser, report, page, query, wanted):
    browser.get((report / f"{page}.html").as_uri())
    browser.find_element(By.ID, "search").send_keys(query)
    links = browser.find_elements(By.CSS_SELECTOR, "#found a")
    hit = next(a for a in links if a.get_attribute("href").endswith("#" + wanted))
    browser.get(hit.get_attribute("href"))
    assert browser.find_element(By.ID, wanted).is_displayed()


def test_nothing_found_is_said_and_verdicts_are_filtered(browser, report):
    browser.get((report / "smith2012.html").as_uri())
    box = browser.find_element(By.ID, "search")
    box.send_keys("zzzz")
    assert "Nothing found" in browser.find_element(By.ID, "found").text
    Select(browser.find_element(By.ID, "filter")).select_by_visible_text("misprint")
    shown = [a for a in browser.find_elements(By.TAG_NAME, "article") if a.is_displayed()]
    assert shown
    assert {a.get_attribute("data-verdict") for a in shown} == {"misprint"}
