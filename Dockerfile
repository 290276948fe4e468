# The programs in an image of Debian 12: `docker build -t rmpl .`, and
# `docker run --rm -u "$(id -u):$(id -g)" -v "$PWD:/models" rmpl rmplc lint burn.scn`.
# SPDX-License-Identifier: MIT
FROM debian:12 AS build
WORKDIR /source
# The packages are a layer of their own: a change of the sources does not fetch them again.
COPY cmake/install-packages cmake/install-packages
RUN cmake/install-packages build && apt-get install --yes --no-install-recommends dpkg-dev
COPY . .
RUN cmake --preset release -DRMPL_TESTS=OFF -DRMPL_UNITY=ON && cmake --build --preset release -j "$(nproc)"
RUN cpack --config build/release/CPackConfig.cmake -B /packages

FROM debian:12
COPY --from=build /packages/rmpl_*.deb /packages/
# Graphviz lays out what `rmplc diagram` draws.
RUN apt-get update && apt-get install --yes --no-install-recommends graphviz /packages/rmpl_*.deb \
    && rm -rf /packages /var/lib/apt/lists/*
WORKDIR /models
CMD ["rmplc", "--help"]
