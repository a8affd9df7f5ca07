# Reads the results of `cargo learn grade` in all formats, and compares them with each other and
# with the fields that their readers document.
import csv, io, json, sys, xml.etree.ElementTree as tree
table, rows, totals, mistakes, junit, gradescope, classroom = sys.argv[1:]
message = "a < b & \"c\"\nsecond line, \u00e4 "
look = "needs a look: 2 copies"
assert table.startswith("=ada: 2.75 of 4, and 1 need a look\n"), table
assert "  ?    " in table, table

# RFC 4180.
read = lambda text: list(csv.DictReader(io.StringIO(text), strict=True))
rows, totals, mistakes = read(rows), read(totals), read(mistakes)
assert [row["points"] for row in rows] == ["2", "0.75", ""], rows
assert [row["max_points"] for row in rows] == ["2", "1", "1"], rows
assert [row["state"] for row in rows] == ["right", "wrong", "needs a look"], rows
assert rows[0]["submission"] == "'=ada" and rows[1]["message"] == message, rows
assert rows[0]["file"] == "ada.zip/%s.rs" % rows[0]["exercise"], rows
counts = dict(right="1", wrong="1", not_handed_in="0", needs_a_look="1")
assert totals == [dict(submission="'=ada", points="2.75", max_points="4", **counts)], totals
(mistake,) = mistakes
assert mistake["mistake"] == "'=1+1" and mistake["names"] == "'=ada", mistakes
assert mistake["exercise"] == rows[1]["exercise"] and mistake["submissions"] == "1", mistakes

# The schema of Jenkins, as far as the grader uses it: for each element the attributes that it
# requires, and the children that it allows: github.com/jenkinsci/xunit-plugin, junit-10.xsd.
SCHEMA = {
    "testsuites": ("", "testsuite"),
    "testsuite": ("name tests failures errors", "testcase"),
    "testcase": ("name classname", "failure error"),
    "failure": ("message", ""),
    "error": ("message", ""),
}
junit = tree.fromstring(junit.encode())
for element in junit.iter():
    attributes, children = SCHEMA[element.tag]
    assert sorted(element.keys()) == sorted(attributes.split()), element.keys()
    assert all(child.tag in children.split() for child in element), element.tag
suite, = junit
assert (suite.get("name"), suite.get("tests")) == ("=ada", "3")
assert (suite.get("failures"), suite.get("errors")) == ("1", "1")
right, wrong, unclear = suite
assert len(right) == 0 and wrong.find("failure").text == message
assert wrong.find("failure").get("message") == message.split("\n")[0]
assert unclear.find("error").text == look

# gradescope-autograders.readthedocs.io/en/latest/specs
gradescope = json.loads(gradescope)
assert gradescope.keys() == {"score", "visibility", "tests"}
assert gradescope["visibility"] in ("hidden", "after_due_date", "after_published", "visible")
for test in gradescope["tests"]:
    assert test.keys() == {"name", "score", "max_score", "status", "output", "output_format"}
    assert type(test["name"]) is str and type(test["output"]) is str
    assert 0 <= test["score"] <= test["max_score"]
    assert test["status"] == ("passed" if test["score"] == test["max_score"] else "failed")
    assert test["output_format"] in ("text", "html", "simple_format", "md", "ansi")
assert gradescope["score"] == sum(test["score"] for test in gradescope["tests"]) == 2.75
assert [test["output"] for test in gradescope["tests"]] == ["right", message, look]

# github.com/foundation50/classroom50/wiki/Advanced-Autograding
classroom = json.loads(classroom)
for name in "classroom assignment submission commit release review datetime".split():
    assert type(classroom[name]) is str, name
assert classroom["schema"] == "classroom50/result/v1"
for name in ("score", "max-score"):
    assert type(classroom[name]) is int
    assert classroom[name] == sum(test[name] for test in classroom["tests"])
for test in classroom["tests"]:
    assert type(test["test-name"]) is str
    assert test["passed"] is (test["score"] == test["max-score"])
assert [test["message"] for test in classroom["tests"]] == ["right", message, look]
