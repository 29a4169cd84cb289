"""Stages: one file per kind of node of the plan, and the only place that joins the parts.

Every stage has ``run(spec, inputs, outputs)``: the node's canonical spec, the files of its input nodes, the files to
write. Whatever a stage imports that is heavy, it imports itself.
"""
