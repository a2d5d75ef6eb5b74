"""The one kind of error that a user can mend: a sentence with its place and its remedy."""


class CampaignError(Exception):
    pass


def at(file, line, field, sentence):
    """FILE:LINE: FIELD: sentence."""
    return CampaignError(f"{file}:{line}: {field}: {sentence}" if field else f"{file}:{line}: {sentence}")
