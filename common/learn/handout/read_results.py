# Reads the results of `cargo learn grade` in all formats, and compares them.
import csv, io, json, sys, xml.etree.ElementTree as tree
table, rows, junit, gradescope, classroom = sys.argv[1:]
rows = list(csv.DictReader(io.StringIO(rows)))
message = "a < b & \"c\"\nsecond line, \u00e4"
assert [row["points"] for row in rows] == ["1", "0"], rows
assert rows[0]["submission"] == "'=ada" and rows[1]["message"] == message, rows
suite, = tree.fromstring(junit.encode()).findall("testsuite")
assert (suite.get("name"), suite.get("tests"), suite.get("failures")) == ("=ada", "2", "1")
right, wrong = suite.findall("testcase")
assert right.find("failure") is None and wrong.find("failure").text == message
assert wrong.find("failure").get("message") == message.split("\n")[0]
gradescope, classroom = json.loads(gradescope), json.loads(classroom)
for test in gradescope["tests"]:
    assert type(test["score"]) is int and test["status"] in ("passed", "failed"), test
assert gradescope["score"] == sum(test["score"] for test in gradescope["tests"]) == 1
assert gradescope["visibility"] == "visible" and gradescope["tests"][1]["output"] == message
for name in "classroom assignment submission commit release review datetime".split():
    assert type(classroom[name]) is str, name
assert classroom["schema"] == "classroom50/result/v1"
for name in ("score", "max-score"):
    assert type(classroom[name]) is int
    assert classroom[name] == sum(test[name] for test in classroom["tests"])
assert [test["passed"] for test in classroom["tests"]] == [True, False]
