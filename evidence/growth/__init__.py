"""Small and long logs that leave much open: does the cost of a log grow with its length alone?"""
