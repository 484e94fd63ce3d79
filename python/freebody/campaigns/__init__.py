"""Campaigns: ensembles of any size in a store, chunk by chunk, on one machine or on a cluster."""

from .campaign import run_campaign
from .cluster import connected
from .stored_runs import StoredRuns, open_runs
from .until import campaign_until

__all__ = ["StoredRuns", "campaign_until", "connected", "open_runs", "run_campaign"]
