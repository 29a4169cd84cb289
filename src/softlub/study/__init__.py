"""Studies: from a study file to the plan of what is to be computed.

Nothing here solves anything or imports what does: the workflow imports this at every start.
"""

from softlub.study.messages import StudyError
from softlub.study.nodes import Node, Plan, merge
from softlub.study.parsed import Study
from softlub.study.planning import plan
from softlub.study.reader import load
from softlub.study.selection import select, study_files

__all__ = ["Node", "Plan", "Study", "StudyError", "load", "merge", "plan", "select", "study_files"]
