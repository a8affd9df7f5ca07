# Reads the results of `cargo learn grade` in all formats, and compares them with each other and
# with the fields that their readers document.
import csv, io, json, sys, xml.etree.ElementTree as tree
table, rows, junit, gradescope, classroom = sys.argv[1:]
message = "a < b & \"c\"\nsecond line, \u00e4"
assert table.startswith("=ada: 1 of 2\n"), table

# RFC 4180.
rows = list(csv.DictReader(io.StringIO(rows), strict=True))
assert [row["points"] for row in rows] == ["1", "0"], rows
assert rows[0]["submission"] == "'=ada" and rows[1]["message"] == message, rows

# The schema of Jenkins, as far as the grader uses it: for each element the attributes that it
# requires, and the children that it allows: github.com/jenkinsci/xunit-plugin, junit-10.xsd.
SCHEMA = {
    "testsuites": ("", "testsuite"),
    "testsuite": ("name tests failures errors", "testcase"),
    "testcase": ("name classname", "failure"),
    "failure": ("message", ""),
}
junit = tree.fromstring(junit.encode())
for element in junit.iter():
    attributes, children = SCHEMA[element.tag]
    assert sorted(element.keys()) == sorted(attributes.split()), element.keys()
    assert all(child.tag in children.split() for child in element), element.tag
suite, = junit
assert (suite.get("name"), suite.get("tests"), suite.get("failures")) == ("=ada", "2", "1")
right, wrong = suite
assert len(right) == 0 and wrong.find("failure").text == message
assert wrong.find("failure").get("message") == message.split("\n")[0]

# gradescope-autograders.readthedocs.io/en/latest/specs
gradescope = json.loads(gradescope)
assert gradescope.keys() == {"score", "visibility", "tests"}
assert gradescope["visibility"] in ("hidden", "after_due_date", "after_published", "visible")
for test in gradescope["tests"]:
    assert test.keys() == {"name", "score", "max_score", "status", "output", "output_format"}
    assert type(test["name"]) is str and type(test["output"]) is str
    assert type(test["score"]) is int and 0 <= test["score"] <= test["max_score"] == 1
    assert test["status"] == ("passed" if test["score"] else "failed")
    assert test["output_format"] in ("text", "html", "simple_format", "md", "ansi")
assert gradescope["score"] == sum(test["score"] for test in gradescope["tests"]) == 1
assert gradescope["tests"][1]["output"] == message

# github.com/foundation50/classroom50/wiki/Advanced-Autograding
classroom = json.loads(classroom)
for name in "classroom assignment submission commit release review datetime".split():
    assert type(classroom[name]) is str, name
assert classroom["schema"] == "classroom50/result/v1"
for name in ("score", "max-score"):
    assert type(classroom[name]) is int
    assert classroom[name] == sum(test[name] for test in classroom["tests"])
for test in classroom["tests"]:
    assert type(test["test-name"]) is str and test["passed"] is (test["score"] == 1)
assert [test["message"] for test in classroom["tests"]] == ["right", message]
