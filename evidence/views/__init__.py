"""What is shown of the specification and its checks: pages and files that are made from other files."""
