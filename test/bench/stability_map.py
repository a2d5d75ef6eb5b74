"""Which stands are stable, by gain, ground and step: the campaign test/bench/campaigns/stability.yaml."""

import tempfile

import on_campaign

KEYS = ("gain", "stiffness", "step")


def cells(method, smallest, who):
    """[{gain, stiffness, step, result}] of one of our methods, steps from `smallest` [s] on, in the order of the file."""
    campaign = on_campaign.read("stability")
    campaign["cases"] = {method: campaign["cases"][method]}
    campaign["settings"]["step"] = [h for h in campaign["settings"]["step"] if h > 0.999 * smallest]
    with tempfile.TemporaryDirectory() as folder:
        rows = on_campaign.run("stability", campaign, folder, who)
    found = [{**{key: float(row[key]) for key in KEYS}, "result": row["result"] or row["status"]} for row in rows]
    return sorted(found, key=lambda cell: (cell["gain"], cell["stiffness"], -cell["step"]))
