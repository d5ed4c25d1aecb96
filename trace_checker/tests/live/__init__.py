"""Tests of s7check watch."""
