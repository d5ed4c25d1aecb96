"""Do the trace checker's engine and TLC give the same verdict about the same logs?"""
