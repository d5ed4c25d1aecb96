"""``s7check mcp``: the checker as tools of a language model, by the Model Context Protocol.

- ``tools``: the tools, which ask what the commands ask
- ``command``: the server on standard input and output
"""
