"""The flight recorder: what is recorded, how it is read, replayed and shown. doc/flight-recorder.md"""
