"""Claims: what the source states, and whether the numbers of our studies bear it out.

`config/claims.csv` holds the statements as facts; the chapters' files hold one small check per statement.
"""

from softlub.claims.caption import caption, studies_of
from softlub.claims.evaluate import Judgement, evaluate
from softlub.claims.table import Claim, read_claims, write_judgements, write_page
from softlub.claims.verdict import Verdict

__all__ = [
    "Claim",
    "Judgement",
    "Verdict",
    "caption",
    "evaluate",
    "read_claims",
    "studies_of",
    "write_judgements",
    "write_page",
]
