# Sphinx configuration of the documentation site; docs/site/make.py writes its sources.
project = "Wrinkle"
extensions = ["myst_parser"]
root_doc = "README"
source_suffix = {".md": "markdown"}
exclude_patterns = ["graphs/**", "core/**"]
html_theme = "furo"
html_title = "Wrinkle"
html_show_sphinx = False
html_show_copyright = False
html_copy_source = False
html_favicon = "wrinkle.svg"
html_logo = "wrinkle.svg"
myst_heading_anchors = 4
myst_enable_extensions = ["html_image"]
highlight_language = "none"
