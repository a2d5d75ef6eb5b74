# A stack in a container, with its page for a browser outside:
#
#   docker build -t twinbus .
#   docker run --rm -it -p 8040:8040 --cap-add SYS_NICE --ulimit rtprio=90 --ulimit memlock=-1 twinbus
#
# and open the address that it prints, which has the token.  Where the port is published under another name, say so:
# -e TWINBUS_VIEWER_AT=HOST:PORT.  Without the three options after the port there is no FIFO priority, and `up` says so.
# Any command may follow: docker run --rm twinbus run sway --for 2.  test/clean_root/dockerfile_test.py runs these lines.
FROM debian:trixie-slim AS build
WORKDIR /twinbus
COPY . .
RUN ./twinbus env
# The packages of the libraries that the programs need, and no others.
RUN ldd build/release/bin/* | awk '/=> \//{print $3}' | sort -u | xargs readlink -f | xargs dpkg-query -S | cut -d: -f1 | sort -u >build/libraries.txt

FROM debian:trixie-slim
WORKDIR /twinbus
COPY --from=build /twinbus/build/libraries.txt build/libraries.txt
RUN apt-get update && apt-get install -y --no-install-recommends $(cat build/libraries.txt) && rm -rf /var/lib/apt/lists/*
COPY --from=build /twinbus/build/release/bin build/release/bin
COPY --from=build /twinbus/build/release/lib build/release/lib
COPY --from=build /twinbus/config config
COPY --from=build /twinbus/viewer_log/web/dist viewer_log/web/dist
ENV TWINBUS_VIEWER_AT=localhost:8040
EXPOSE 8040
ENTRYPOINT ["/twinbus/build/release/bin/twinbus"]
CMD ["up", "stand", "--listen", "0.0.0.0"]
